### Sentences of diagnostics and of the command line; the names are those of text/en/diagnostics.ftl.

diag-error-a6c0 = ошибка
diag-warning-6bce = предупреждение
diag-help-9b8b = подсказка
diag-did-you-mean-dcdc = возможно, имелось в виду { $near }? { $list }
diag-did-you-mean-fa5e = возможно, имелось в виду { $near }?
diag-bodies-of-this-machine-e555 = тела этой машины: { $all }
diag-is-attached-to-which-does-not-e3d3 = { $kind } «{ $block }»: присоединение к телу «{ $name }», которого нет
diag-no-such-body-1f1f = такого тела нет
diag-also-named-in-line-e5a1 = { $message } (также в строке { $line })
diag-also-named-in-lines-and-6dd4 = { $message } (также в строках { $lines } и { $last })
diag-also-named-in-lines-and-more-5c20 = { $message } (также в строках { $lines } и ещё в { $left })
diag-and-more-9d04 = ... и ещё { $n }
