# The machine beside its approximation with few waves.
approximation-modes = Жуықтау – { $degree }-дәрежелі көпмүше. Оның { $modes } модасының { $met } модасы толық машинаның түбірінен ең көбі { $within } қашықтықта жатыр. Ең үлкен ауытқу { $value }, { $speed } кезінде: жиілігі { $whole_frequency } орнына { $frequency }, өсу жылдамдығы { $whole_growth } орнына { $growth }.
approximation-growth = Ең үлкен өсу жылдамдығы: толық машинада { $whole_growth }, { $whole_speed } кезінде; жуықтауда { $growth }, { $speed } кезінде. Айырмасы { $value }.
