# Spectra along a motion.

# Components of the motion of a body.
spectra-superharmonic = { $whirl ->
        [forward] Forward
       *[backward] Backward
    } superharmonic of order { $order } of "{ $body }"
spectra-spin-frequency = { $whirl ->
        [forward] Forward
       *[backward] Backward
    } component of "{ $body }" at the spin frequency
spectra-subharmonic = { $whirl ->
        [forward] Forward
       *[backward] Backward
    } subharmonic of order { $p }/{ $q } of "{ $body }"
spectra-fraction = { $whirl ->
        [forward] Forward
       *[backward] Backward
    } component of order { $p }/{ $q } of "{ $body }"
spectra-asynchronous = { $whirl ->
        [forward] Forward
       *[backward] Backward
    } asynchronous component of "{ $body }", at { $order } times the spin frequency

spectra-component = { $component }: above { $limit } from { $value } to { $to }, largest { $largest } at { $at }.{ $course ->
        [intermittent] {" "}It exceeds the threshold in { $count } of { $between } windows.
       *[throughout] {""}
    }
spectra-component-at-speed = { $component }: above { $limit } at { $value }, largest { $largest }.{ $course ->
        [intermittent] {" "}It exceeds the threshold in { $count } of { $between } windows.
       *[throughout] {""}
    }
spectra-more-components = { $count ->
        [one] One more component of "{ $body }" exceeds
       *[other] { $count } more components of "{ $body }" exceed
    } { $limit }.
spectra-fleeting = Components of "{ $body }" exceed { $limit } in single windows only, like a decaying free vibration: up to { $value } at { $speed }.
spectra-no-components = No component of "{ $body }" beside the synchronous one exceeds { $limit }.{ $short ->
        [0] {""}
        [one] {" "}One window of fewer than four turns is left out.
       *[other] {" "}{ $short } windows of fewer than four turns are left out.
    }
spectra-no-lasting-components = No lasting component of "{ $body }" beside the synchronous one exceeds { $limit }.{ $short ->
        [0] {""}
        [one] {" "}One window of fewer than four turns is left out.
       *[other] {" "}{ $short } windows of fewer than four turns are left out.
    }
spectra-no-motion = "{ $body }" does not vibrate: its spectra are zero.
spectra-no-orders = No order spectra: the windows of the waterfall hold fewer than four turns of the rotor. Request fewer spectra.
spectra-none = No spectra: the motion ended before the first window of the waterfall.
