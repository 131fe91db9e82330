### Sentences of diagnostics and of the command line; the names are those of text/en/diagnostics.ftl.

diag-error-a6c0 = қате
diag-warning-6bce = ескерту
diag-help-9b8b = кеңес
diag-did-you-mean-dcdc = мүмкін, { $near } деп жазбақ болдыңыз ба? { $list }
diag-did-you-mean-fa5e = мүмкін, { $near } деп жазбақ болдыңыз ба?
diag-bodies-of-this-machine-e555 = бұл машинаның денелері: { $all }
diag-is-attached-to-which-does-not-e3d3 = { $kind } «{ $block }»: бекітілген «{ $name }» денесі жоқ
diag-no-such-body-1f1f = мұндай дене жоқ
diag-also-named-in-line-e5a1 = { $message } ({ $line } жолында да бар)
diag-also-named-in-lines-and-6dd4 = { $message } ({ $lines } және { $last } жолдарында да бар)
diag-also-named-in-lines-and-more-5c20 = { $message } ({ $lines } жолдарында және тағы { $left } жерде бар)
diag-and-more-9d04 = ... және тағы { $n }
