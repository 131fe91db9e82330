# The machine is unstable where a response or critical speeds are reported.
growing-unstable = Машина орнықсыз: { $place ->
        [one] { $from } кезінде
        [all] есептелген барлық айналу жиілігінде, { $from } – { $to } аралығында
        [single] есептелген { $computed } айналу жиілігінің бірінде, { $from }
       *[several] есептелген { $computed } айналу жиілігінің { $unstable } мәнінде, { $from } – { $to } аралығында
    }. { $place ->
        [one] Өсу жылдамдығы { $value }
        [single] Өсу жылдамдығы { $value }
       *[several] Ең үлкен өсу жылдамдығы { $value }, { $speed } кезінде
    }, { $motion ->
        [divergence] статикалық орнықсыздық (дивергенция)
       *[whirl] прецессия жиілігі { $frequency }
    }. { $follows ->
        [response] Ондағы амплитудалар мен резонанстар орнықсыз шешімге жатады: алдымен орнықсыздықты жойыңыз.
       *[speeds] Ондағы сындық айналу жиіліктері мен алшақтық қоры жарамсыз: алдымен орнықсыздықты жойыңыз.
    }
