# Words of the studio's page. Its script names them; the values are put in there.
studio-text = Machine file
studio-machine = Machine
studio-figures = Results
studio-view = View
studio-tab-text = Text
studio-tab-machine = Machine
studio-tab-figures = Results
studio-tab-section = Section
studio-tab-space = 3-D
studio-want-page = First page of the report
studio-want-modes = Modes
studio-want-campbell = Campbell diagram
studio-want-stability = Stability
studio-want-forced = Unbalance response
studio-want-nonlinear = Nonlinear response
studio-short-page = First page
studio-short-modes = Modes
studio-short-campbell = Campbell
studio-short-stability = Stability
studio-short-forced = Unbalance
studio-short-nonlinear = Nonlinear
studio-nothing = No result for this machine.

# File and text.
studio-open = Open
studio-save = Save
studio-save-as = Save as
studio-saved = { $name } is saved.
studio-unsaved = Changes are not saved.
studio-new-file = new file
studio-file-name = File name
studio-file-name-wrong = A file name of this folder is needed that ends in .toml, such as rotor.toml.
studio-files = Files of this folder
studio-examples = Examples
studio-changed-on-disk = The file on disk is different
studio-overwrite = Overwrite
studio-load-from-disk = Load from disk
studio-undo = Undo
studio-redo = Redo
studio-errors = Errors in the file ({ $count }). The first
studio-lost = No connection to the program. The text is kept here; the connection is tried every second.
studio-unsent = Sent when the connection is back: { $name }.
studio-close = Close
studio-language = Language
studio-theme-system = Colours: system
studio-theme-light = Colours: light
studio-theme-dark = Colours: dark
studio-unit = unit
studio-default = default

# Parameters and handles.
studio-parameters = Parameters
studio-parameter = Parameter
studio-value = value
studio-range = Range
studio-from = From
studio-to = To
studio-drag-this = Drag: { $name }, { $value }

# Motion in 3-D.
studio-motion = Motion
studio-motion-forced = Linear unbalance response at { $value } rpm
studio-motion-nonlinear = Nonlinear unbalance response at { $value } rpm
studio-motion-state = state { $count }
studio-motion-unstable = unstable
studio-motion-start = Transient from equilibrium at { $value } rpm
studio-motion-transient = Transient “{ $name }”
studio-shown = Largest displacement: { $value }. Shown { $from } times larger, { $to } times slower.
studio-computing = Computation in progress
studio-time = { $value } s
studio-mode = Mode { $count }
studio-whirl-forward = forward
studio-whirl-backward = backward
studio-whirl-mixed = mixed
studio-whirl-axial = along the axis
studio-whirl-torsional = torsional
studio-whirl-none = no whirl
studio-play = Play
studio-pause = Pause
studio-amplitude = Amplitude
studio-speed = Speed
studio-rpm = rpm
studio-hertz = Hz
studio-grows = grows at { $value } 1/s
studio-decays = decays at { $value } 1/s
studio-space-help = Machine in 3-D. Drag or use the arrow keys to turn it; plus and minus change the distance.
studio-no-space = This browser does not draw in 3-D.

# Results that are set by dragging.
studio-reach = Set a result
studio-released = free
studio-released-help = The program may change this parameter within its range.
studio-release-first = Mark one or more parameters as free, then drag a critical speed, a stability limit, a peak or a jump in a figure.
studio-pull-help = Free parameters: { $count }. Drag a critical speed, a stability limit, a peak or a jump in a figure.
studio-pull-this = Drag: { $name }
studio-reach-running = Looking for values with which { $name } lies at { $value } …
studio-reached = { $name }: { $value } is reached.
studio-not-reached = { $name }: { $value } is not reached.
studio-share-column = Share
studio-at-bound = at its bound
studio-take-nearest = Use the nearest values
studio-not-a-number = A number is needed, in { $name } or with a unit of the same kind.
studio-trade = Trade-off
studio-trade-curve = Change of the free parameters over the result
studio-change = change of the parameters,
studio-alone = Alone
studio-result = Result

# Comparison and sharing.
studio-pin = Pin
studio-pin-help = Keep this design beside the text for comparison.
studio-share = Share
studio-share-help = One HTML file with text, results and pinned designs.
studio-compare = Comparison
studio-check = Check
studio-now = Now
studio-design = Design
studio-name = Name
studio-take-back = Restore
studio-take-back-this = Restore { $name }
studio-remove = Remove
studio-remove-this = Remove { $name }

# Runs of studies.
studio-runs = Studies of the file
studio-no-studies = The file has no studies.
studio-run = Run
studio-run-this = Run { $name }
studio-resume = Resume
studio-cancel = Cancel
studio-report = Report
studio-state-waiting = waiting
studio-state-running = running
studio-state-paused = paused
studio-state-done = done
studio-state-cancelled = cancelled
studio-state-failed = failed
