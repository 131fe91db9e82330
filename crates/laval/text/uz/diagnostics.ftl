### Sentences of diagnostics and of the command line; the names are those of text/en/diagnostics.ftl.

diag-error-a6c0 = xato
diag-warning-6bce = ogohlantirish
diag-help-9b8b = maslahat
diag-did-you-mean-dcdc = balki { $near } demoqchi bo‘lgandirsiz? { $list }
diag-did-you-mean-fa5e = balki { $near } demoqchi bo‘lgandirsiz?
diag-bodies-of-this-machine-e555 = bu mashinaning jismlari: { $all }
diag-is-attached-to-which-does-not-e3d3 = { $kind } "{ $block }": biriktirilgan "{ $name }" jismi mavjud emas
diag-no-such-body-1f1f = bunday jism yo‘q
diag-also-named-in-line-e5a1 = { $message } ({ $line }-qatorda ham bor)
diag-also-named-in-lines-and-6dd4 = { $message } ({ $lines } va { $last }-qatorlarda ham bor)
diag-also-named-in-lines-and-more-5c20 = { $message } ({ $lines }-qatorlarda va yana { $left } joyda bor)
diag-and-more-9d04 = ... va yana { $n } ta
