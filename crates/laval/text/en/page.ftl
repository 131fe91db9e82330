# Words of the report's own page and of the terminal, beside those of the first page.

page-nameless = machine without a name
page-report = laval report
page-from = from { $file }
# In front of the first digits of the hash of the input file.
page-hash = input
page-results = Findings
page-studies = Studies
page-kind = kind
page-bracket = bracket width
page-status = status
page-doubtful = doubtful: { $reason }
page-first-rows = The first { $first } of { $count ->
        [one] 1 row
       *[other] { $count } rows
    }.
# In front of the name of a file.
page-all-values = All values:
page-no-data = no data in this range
page-also-marked = Also marked: { $labels }
page-nothing-to-report = done, nothing to report

# Buttons and lists of a motion that is played.
play-play = Play
play-pause = Pause
play-time = Time
play-axes = Reference frame
play-turning = rotating frame
play-fixed = stationary frame
play-pace = Pace
play-whole = all in 20 s
play-turn = one revolution per second
