# The frame of the report page: names that stand beside numbers, columns and files.
page-nameless = атаусыз машина
page-report = laval есебі
page-from = { $file } файлынан
page-hash = бастапқы деректер
page-results = Тұжырымдар
page-studies = Зерттеулер
page-kind = түрі
page-bracket = аралық ені
page-status = күйі
page-doubtful = күмәнді: { $reason }
page-first-rows = { $count ->
        [one] Жалғыз жол.
       *[other] { $count } жолдың алғашқы { $first } жолы.
    }
page-all-values = Барлық мәндер:
page-no-data = бұл ауқымда дерек жоқ
page-also-marked = Сондай-ақ белгіленген: { $labels }
page-nothing-to-report = орындалды, хабарлайтын ештеңе жоқ

# Buttons and lists of a motion that is played.
play-play = Ойнату
play-pause = Кідірту
play-time = Уақыт
play-axes = Санақ жүйесі
play-turning = айналатын санақ жүйесі
play-fixed = қозғалмайтын санақ жүйесі
play-pace = Жылдамдық
play-whole = бәрі 20 с ішінде
play-turn = секундына бір айналым
