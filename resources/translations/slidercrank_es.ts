<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>slidercrank::AnimationExport</name>
    <message>
        <source>%1: a video needs the program ffmpeg, which is not installed; choose .png for frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: an animation&apos;s name must end in .%2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or .</source>
        <comment>between the endings of file names</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than %1 frames: choose a shorter run or fewer frames a second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ffmpeg could not be started: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for a frame of that size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: is the disk full?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ffmpeg could not make the video: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it ended early.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::ColumnMapping</name>
    <message>
        <source>ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none given: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as printed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say what the columns are; the choice is remembered for files with the same headings. Below is what would be read from the chosen column.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview of the chosen column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use these columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guess anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets what was chosen for files with these headings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chosen by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t = %1 … %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 from %3 to %4 %5, %6</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::ColumnText</name>
    <message>
        <source>columns separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns separated by semicolons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns separated by tabs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns separated by spaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns separated by “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s (none given)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (none given)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its name is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chosen by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: its name says the quantity, and this is the body usually exported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: P, V or A says the order, its unit says angle or length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: P, V or A says the order, its values tell an angle from a length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: its values are the derivative of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: an angle that grows at an even rate, as the crank&apos;s does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: the first column whose values only rise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored: its name means no channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored: it has no name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored: it holds no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored: its unit is not known or does not suit the quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored: “%1” could be the same quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored: its values are not the derivative of “%1” that its name says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored: neither its unit nor its values tell an angle from a length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed by its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed by its unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed by its values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: derivative of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: even rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: only rises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no number in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as %1 could be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not the derivative of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle or length?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 significant digit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 significant digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whole multiples of 1e%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 decimal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 decimals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decimal point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no names of columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names in line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>units in line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1 above them passed over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lines above them passed over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::CommandLine</name>
    <message>
        <source>Read so, it agrees with this mechanism.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file&apos;s own mechanism: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model: a = %1 mm, b = %2 mm, c = %3 mm, ω2 = %4 rad/s, θ20 = %5 rad, %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files: %2 agree, %3 come close, %4 differ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: t = %3 s to %4 s, %2 instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at t [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zeros</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rounding step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: rows that could not be read and were skipped: %2, the first in line %3, column %4 (&quot;%5&quot;): %6.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: these columns are no channels and were ignored: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank length O2-A, &gt; 0 (20)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coupler length A-B, &gt; 0 (65)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset of the slider&apos;s line from O2 (25)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank speed, constant (2π)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank angle at t = 0 (0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assembly: slider to the right of A, or to the left (open)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a saved scene that gives these and whatever else it knows; an option beside it wins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intervals; N + 1 instants, both ends (200)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length of the run, &gt; 0 (1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first instant (0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one instant instead of a run: the first from --start at which θ2 is this angle, whole turns apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the motion is computed (newton)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of Newton-Raphson, an instant, &gt;= 1 (10)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual ‖C‖ at which Newton-Raphson stops; 0: when it no longer falls (1e-8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relative: the length rows of C divided by a + b + |c| (absolute: mm and rad as they are)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all, or names with commas: theta3,R4_x_diff (all)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit of the angles written (deg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what to write (csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write there, not to standard output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what to write (text: a table)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exit status 1 when a channel differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what to write (text)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nominal: the mechanism of these options; hard: the named hard cases, behind the mechanism if one is given; all: the named nominal and hard cases (nominal)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>figure (the nine plots), mechanism, report (on A4, PDF), or one plot: theta3, R4_x, theta3_diff, R4_x_diff, theta3_diff2, R4_x_diff2, error_position, error_velocity, error_acceleration (figure)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name that ends in .png, .svg or .pdf; needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a simulation&apos;s CSV file to draw beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels (figure 1400x1800, mechanism 900x700, plot 900x600)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of a PNG&apos;s pixels, 0.1 to 10 (1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colours (light)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instant of the pose, marked in the plots (--start)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same by crank angle: the first instant from --start at which θ2 is this angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a simulation&apos;s CSV file to open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forget the window&apos;s layout, the recent files, the theme and the choices of columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name and version of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: slidercrank [SCENE.json] [options]      opens the window
       slidercrank solve [options]             the motion as CSV or JSON
       slidercrank compare FILE… [options]     how far simulations&apos; files are from the model
       slidercrank identify FILE [options]     the mechanism that a file belongs to
       slidercrank study [options]             speed against error of every method
       slidercrank render --output FILE [...]  a picture or a report: PNG, SVG or PDF

Motion of an offset slider-crank. &quot;slidercrank solve --help&quot; and so on tell the options of each.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: slidercrank solve [options]

Computes the motion and writes a row an instant: time (s), then the channels asked for: positions
(R1_x, R1_y, theta1, R2_x … theta4; mm, °), their first derivatives (theta3_diff) and their
second (theta3_diff2), 17 significant digits, nan where a value does not exist.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: slidercrank compare FILE… [options]

Reads simulations&apos; CSV files (time,R4_x,theta3_diff,… as Inventor exports them) and tells how far each of their
columns is from the exact motion of the mechanism at the file&apos;s own instants. A column agrees when at least
95 % of its values are within half a rounding step of the file and none beyond ten halves, is close when none
is beyond a hundred halves, and differs otherwise. Where one differs, the text says what explains it. A file that
cannot be read is told on standard error, and the others are still compared.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: slidercrank identify FILE [options]

Finds the mechanism that a simulation&apos;s file belongs to, from any of the columns theta3, R4_x and their
derivatives, and how certain each of its parameters is. Where the file means something else by a column than its
heading says (radians, the textbook&apos;s angle, another sign, …), that is said, and the file is read so. The options
of the mechanism give what the file cannot fix.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: slidercrank study [options]

Times every method on the same instants and measures its error against the exact motion in 50 to 100 digits: the
worst of the six plotted channels, relative to the channel&apos;s peak, over the instants that the method calls
solved. Beside it the bound κ·u: the error that rounding the given numbers makes by itself. newton-dense is the
report&apos;s way, with its absolute tolerance; the others measure the residual relative to a + b + |c|.
finite-difference differentiates positions sampled 200 times a turn; harmonic-N keeps N harmonics.
Times depend on the machine: compare them within one run.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: slidercrank render --output FILE.png|.svg|.pdf [options]

Draws what the window shows into a file, or writes a report of it. Needs no display.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A header name stands alone for mm, ° and s; any other unit stands behind it: theta3_diff [rad/s].

JSON: {&quot;mechanism&quot;:{&quot;a&quot;,&quot;b&quot;,&quot;c&quot;,&quot;omega2&quot;,&quot;theta20&quot;,&quot;branch&quot;}, &quot;method&quot;:&quot;newton&quot;|&quot;closed-form&quot;,
       &quot;units&quot;:{&quot;length&quot;:&quot;mm&quot;,&quot;angle&quot;:&quot;deg&quot;|&quot;rad&quot;,&quot;time&quot;:&quot;s&quot;}, &quot;time&quot;:[…], &quot;channels&quot;:{&quot;theta3&quot;:[…],…}};
      the mechanism in mm and rad as in the options, null where a value does not exist.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON: {&quot;files&quot;:[{&quot;file&quot;, &quot;mechanism&quot;:{&quot;a&quot;,&quot;b&quot;,&quot;c&quot;,&quot;omega2&quot;,&quot;theta20&quot;,&quot;branch&quot;}, &quot;channels&quot;:[…],
       &quot;skipped&quot;:[{&quot;line&quot;,&quot;column&quot;,&quot;text&quot;,&quot;reason&quot;}], &quot;ignoredColumns&quot;:[…]}]}; a channel is
      {&quot;name&quot;,&quot;unit&quot;,&quot;count&quot;,&quot;maxAbs&quot;,&quot;timeOfMaxAbs&quot;,&quot;rms&quot;,&quot;maxPercent&quot;,&quot;timeOfMaxPercent&quot;,
       &quot;zeroReference&quot;,&quot;percentOfPeak&quot;,&quot;roundingStep&quot;,&quot;verdict&quot;} in mm, ° and s; null where there is none.
CSV: the file&apos;s name, then the same columns.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON: {&quot;file&quot;, &quot;mechanism&quot;:{&quot;a&quot;,&quot;b&quot;,&quot;c&quot;,&quot;omega2&quot;,&quot;theta20&quot;,&quot;branch&quot;}, &quot;standardError&quot;:{&quot;a&quot;,…},
       &quot;identifiable&quot;:{&quot;a&quot;:true,…}, &quot;iterations&quot;, &quot;conditionNumber&quot;, &quot;channels&quot;:[as of compare, against it],
       &quot;conventions&quot;:[{&quot;name&quot;,&quot;explanation&quot;,&quot;before&quot;,&quot;after&quot;}], &quot;summary&quot;}; in mm and rad as the options;
      before, after: largest error, % of peak; null where there is none.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON: {&quot;machine&quot;, &quot;cases&quot;:[{&quot;name&quot;, &quot;methods&quot;:[…]}]}; a method is
      {&quot;method&quot;,&quot;tolerance&quot;,&quot;channels&quot;,&quot;nsPerState&quot;,&quot;spread&quot;,&quot;iterationsPerState&quot;,&quot;maxError&quot;,
       &quot;errorBound&quot;,&quot;status&quot;,&quot;counts&quot;,&quot;silentFailures&quot;}; spread: between the quartiles, in ns; status: the worst;
       counts: instants by status; silentFailures: instants called solved and wrong; null where there is none.
CSV: the case&apos;s name, then the same columns, a column a status.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exit status: 0 done; 1 --fail-on-difference and a channel differs; 2 the command line is wrong; 3 a file or
standard output cannot be read or written, or a file is not what it should be; 4 the mechanism cannot be
assembled at some instant (the others are still written); 5 Newton-Raphson did not converge, or velocity and
acceleration do not exist, somewhere, or no mechanism was found for a file. Of several, 3, 4, 5, 1 in this order.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>± one standard deviation; %1 iterations, condition number %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To go on with it: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings in %1 cannot be written: remove them there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgotten: the window&apos;s layout, the recent files, the theme and the choices of columns.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no display to open the window on: set DISPLAY, or use solve, compare, identify, study or render, which need none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;slidercrank --help&quot; lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;slidercrank %1 --help&quot; lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 must be a number with a decimal point, such as 60 or -0.5, not &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 must be a whole number from %2 to %3, not &quot;%4&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 must be %2, not &quot;%3&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 needs the name of a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 must not exceed 1e12 in magnitude.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 must be greater than 0, not %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--duration must be greater than 0, not %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The instants lie too close together to be told apart: choose fewer --steps, a longer --duration or a --start nearer to 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--tolerance must be 0 or more, not %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank stands still (--omega2 0) and never comes to %1°: choose another --omega2, or set its angle with --theta20.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank turns too slowly to come to %1° within 1e12 s: choose a larger --omega2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--channels: there is no channel &quot;%1&quot;; there are %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--channels: there is no channel &quot;%1&quot;; did you mean %2?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;slidercrank %1&quot; takes options only: remove &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--output would overwrite %1, which is to be read: choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--at-angle asks for one instant and --%1 for a run: remove one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;slidercrank compare&quot; needs a file: slidercrank compare FILE…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;slidercrank identify&quot; needs a file: slidercrank identify FILE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;slidercrank identify&quot; takes one file, not %1: remove &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--what must be figure, mechanism, report or one of the plots %1, not &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;slidercrank render&quot; needs --output with a name that ends in .png, .svg or .pdf.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A report is a PDF: --output must end in .pdf, not be &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--output must end in .png, .svg or .pdf, not be &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A report is always on A4, black on white: remove --%1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--size must be width x height in pixels, each from 100 to %1, such as 900x600, not &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--scale must be from 0.1 to 10, not %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture would be larger than %1 pixels: choose a smaller --size or --scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--at and --at-angle both choose the instant: remove one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cursor&apos;s instant, t = %1 s, lies outside the run from %2 s to %3 s: choose another instant, or another --start or --duration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--reset-settings opens no window: remove what stands beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The command must come first: slidercrank %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;: use solve, compare, identify, study or render, or no word at all, or a scene&apos;s file, for the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window opens one scene, not %1: remove &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no option %1 here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; did you mean %2?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 is given more than once: keep one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 needs a value: --%1 %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard output cannot be written: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another file or folder with --output.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of an offset slider-crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 instants, first at t = %3 s (θ2 = %4°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mechanism cannot be assembled at %1: the coupler must be at least %2 mm long for the crank to turn round (--b).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton-Raphson did not converge at %1: allow more iterations than %2 (--max-iterations), or a larger residual (--tolerance).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity and acceleration do not exist at %1: the coupler stands square to the slider&apos;s line there; a longer coupler (--b) avoids it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion is too large to be a number at %1: choose a smaller --omega2, or instants nearer to 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a = %2 mm, b = %3 mm, c = %4 mm, ω2 = %5 rad/s, θ20 = %6 rad, %7; %8 instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ns/state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bound κu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outcome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 of them silently wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors are the worst of the six plotted channels, relative to the channel&apos;s peak, against 50 to 100 digits, over the
instants that a method calls solved. Silently wrong instants: %1. Machine: %2. Done in %3 s.
</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::EditCommandText</name>
    <message>
        <source>the assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closing of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other reading of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the sampling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the method</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::ErrorPanel</name>
    <message>
        <source>agrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 row of the file was skipped (line %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows of the file were skipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: “%3” %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 column was ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 columns were ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ignored: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors against the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a simulation&apos;s exported motion (CSV) to see how far it is from this mechanism: the largest error of each channel, where it is, and whether it is more than the file&apos;s own rounding.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion that the report&apos;s author exported from Inventor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is compared, and its unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>agrees: at least 95 % of the values within half a step of the file, none beyond ten halves
close: none beyond a hundred halves
differs: anything else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max |model − reference|, in the channel&apos;s unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instant of the largest error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>√( mean of (model − reference)² ), in the channel&apos;s unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max |model − reference| / |reference| · 100, as in the report, over the instants where the reference is not zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instant of the largest percentage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max |model − reference| / max |reference| · 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between neighbouring numbers that the file can write, where it is largest, in the channel&apos;s unit. Rounding alone makes an error of half of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors, a row a channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1%2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to go to the instant of the largest error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in the file, %2 instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; at %1 more there is no motion to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max |model − reference| = %1
%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>√( mean of (model − reference)² ) = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max |model − reference| / |reference| · 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Infinite at %1 instants where the reference is zero; they are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1×∞)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to go to the instant of the largest percentage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file writes this channel in steps of %1 at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not show how it was rounded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::FigureExportText</name>
    <message>
        <source>A figure must be at least 1 pixel wide and high.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scale of a figure must be greater than 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A figure of %1 × %2 pixels is too large: choose a smaller size or scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a figure&apos;s name must end in .png, .svg or .pdf.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for a figure of that size.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::FindingList</name>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now → as the file has it ± standard error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Largest error: %2 → %3 % of peak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this mechanism over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file fits %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not read as printed: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::FindingText</name>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossed assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1/a = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: in %2, but read as %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: in a unit of angle %2 times as large as the one read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: in a unit of length %2 times as large as the one read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time is in milliseconds, but was read as seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time is in seconds, but was read as milliseconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time is in minutes, but was read as seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit of the time is %1 times as large as the one read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; so are the derivatives %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> − %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> + %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies %1 by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the instants by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the instants by %1, and brings %2 to the same unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes the sign of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes %1 continuous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds %1° to %2, made continuous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the other assembly for the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds %1 s to the instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves %1 out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>θ³ alone fixes only b/a and c/a; a = %1 is taken as given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>θ³ alone cannot tell it from one that turns the other way, from 180° − θ₂₀.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The derivatives of θ³ alone cannot tell it from the other assembly with c negated and θ₂₀ half a turn on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rₓ⁴ alone cannot tell this mechanism from its mirror image (c, ω₂ and θ₂₀ negated).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The data do not fix %1: kept as given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It comes nearest of all, but the data are still off by %1 × the file&apos;s rounding step (rms).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are too few values of θ³, Rₓ⁴ and their derivatives to find the mechanism by: export more instants, or more columns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No slider-crank moves as these data do: check which column is which, and their units.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This error looks like %1: %2 instead of %3%4 explains %5 % of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half a turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whole turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swapped columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no derivative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: counted clockwise, against the sense of the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: along an axis that points the other way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: of the opposite sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the coupler&apos;s angle seen from B, as textbooks draw θ₃; θ³ is %1%2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: jumps by whole turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: off by whole turns; θ³ is %1%2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: each stands under the other&apos;s name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file moves as the other assembly: the slider on the other side of A.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file&apos;s clock is %1 s ahead: what it has at t happens that much earlier.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file&apos;s clock is %1 s behind: what it has at t happens that much later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not the time derivative of its position column.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: its largest error is %2 % of peak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: largest error %2 % of peak instead of %3 %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>agrees to the last printed digit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>agrees within %1 × the file&apos;s rounding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differs: nothing to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|model − reference| ≤ ½ step for at least %1 % of the values, ≤ %2 · ½ step for all; the step is that of each value&apos;s last printed digit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|model − reference| ≤ %1 · ½ step for all values; the step is that of each value&apos;s last printed digit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|model − reference| &gt; %1 · ½ step somewhere; the step is that of each value&apos;s last printed digit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At no instant of the file do both the model and the file have a value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> At %1 instants the model has no value to compare with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here: %1 of %2 within ½ step, the worst %3 · ½ step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has no column that this program knows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in its one channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in %1 of %2 channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comes close to this mechanism in every channel, a little beyond the rounding of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agrees with this mechanism %1, within the rounding of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; close in the others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differs from this mechanism %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, most in %1: by up to %2 % of its peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 of the file&apos;s instants the mechanism cannot be assembled, or has no derivatives.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::FoldingTabs</name>
    <message>
        <source>Panels; choosing the current one again folds it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the current tab to fold it away or out</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::LimitsPanel</name>
    <message>
        <source>Click or press Enter to go there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run does not come there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions are Rₓ⁴, those of the slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>θ₂ [°]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle, 0 to 360°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first instant of the run with the crank there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where slider and crank turn back, and how long the strokes take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>peak of a turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest speeds and accelerations over a whole turn of the crank, whatever part of it is sampled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With its sign: x to the right, angles counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits of the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peaks of speed and acceleration</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::MainWindow</name>
    <message>
        <source>crank turns round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank rocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locked in one pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be assembled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton-Raphson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open reference…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open s&amp;cene…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the &amp;sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;figure…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;mechanism…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;animation…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset parameters to Table 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;all of the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;lots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;panels below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the file&apos;s &amp;motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;System colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step &amp;forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled: what is on show is from before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose columns…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The names in %1 do not tell what all of its columns are: some are guessed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene is open without its reference. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation results (*.csv *.txt *.tsv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export animation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbered frames, videos (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images and drawings (*.png *.svg *.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of an offset slider-crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figure is in the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider-crank[*]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Slider-crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crossed assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, no pose at %1 of %2 instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed form (exact)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton-Raphson, at most %1 iterations, residual %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples in %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors ⚠</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 differs from this mechanism. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;slidercrank %1&lt;/h3&gt;&lt;p&gt;The motion of an offset slider-crank: computed, shown, and compared with a simulation.&lt;/p&gt;&lt;p&gt;Formulation after A. A. Shabana, &lt;i&gt;Computational Dynamics&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::MechanismView</name>
    <message>
        <source>Mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider-crank drawn to scale: crank %1 mm, coupler %2 mm, offset %3 mm. Drag the crank pin A to move through time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>O₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no pose at this instant: the crank angle is not a finite number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot be assembled at any crank angle: the coupler does not reach the slider&apos;s line. b must be more than %1 mm for any pose; the crank turns round when b is at least %2 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot be assembled at θ₂ = %1°: the coupler is too short. The crank turns round when b is at least %2 mm.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::MotionFacts</name>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It would turn round with %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a pose with %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outer dead centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the slider (Rₓ⁴) turns back with crank and coupler stretched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inner dead centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the slider (Rₓ⁴) turns back with crank and coupler folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank can go no further: the coupler stands square to the slider&apos;s line. The value is the slider&apos;s position Rₓ⁴.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forward stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank&apos;s turn from the inner to the outer dead centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>return stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank&apos;s turn from the outer to the inner dead centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slower stroke&apos;s time over the faster one&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slider speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slider acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coupler speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coupler acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest over a whole turn: where its own derivative vanishes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>throughout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank turns round: b = %1 ≥ a + |c| = %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank just turns round: b = a = %1, c = 0, a change point. At θ₂ = 90° and 270° the coupler stands square to the slider&apos;s line, and the speeds jump.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank just turns round: b = a + |c| = %1. At θ₂ = %2° the coupler stands square to the slider&apos;s line, and the speeds jump.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank rocks within one of two arcs: b = %1 &lt; a + |c| = %2, and less than a − |c| = %3 mm too. %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank rocks: b = %1 &lt; a + |c| = %2. %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank is locked in one pose: b = |c| − a = %1. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be assembled: b = %1 &lt; |c| − a = %2. %3 %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the slider goes: its largest position less its smallest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least transmission angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between the coupler and the normal to the slider&apos;s line: 90° − |θ³| at its least. Mechanisms with less than 40° or so tend to jam.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accelerations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speeds, accelerations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unbounded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coupler stands square to the slider&apos;s line and the speeds jump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towards the crank&apos;s limit slider and coupler get ever faster</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::NewtonPanel</name>
    <message>
        <source>Newton-Raphson: settings and outcome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton-Raphson</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed form, exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the curves are computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intervals; one instant more is computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the first instant to the last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first instant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iterates until ‖C‖ is at most this; 0: until it no longer falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>absolute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Absolute: mm and rad mixed, as in the report. Relative: lengths divided by a + b + |c|, the same at every scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At one instant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest residual ‖C‖</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the answers, as the tolerance measures it. It bounds the residual, not the error.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in all, at most %2 an instant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: the closed form needs none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>–</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all %1 solved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 solved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 instants did not converge within %3 iterations: allow more iterations or a larger tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 instants did not converge within %3 iterations: allow more iterations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 instants cannot be assembled: the coupler is too short there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 of %2 instants the coupler stands square to the slider&apos;s line: the position exists, velocity and acceleration do not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 instants gave no finite number: the numbers are too large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::ParameterPanel</name>
    <message>
        <source>rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the crank, O₂ to A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coupler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the coupler, A to B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the slider&apos;s line above O₂; may be negative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the crank, counter-clockwise positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the crank at t = 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters of the mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open: slider to the right of A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossed: slider to the left of A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two ways to put the same parts together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the report&apos;s Table 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded: above %1 the crank cannot turn round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded: with this coupler and offset no crank can turn round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded: below %1 the crank cannot turn round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded: beyond ±%1 the crank cannot turn round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded: with a crank longer than the coupler no offset lets it turn round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded: with the crank there the mechanism cannot be assembled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::PlotFigure</name>
    <message>
        <source>does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2</source>
        <comment>units of the left and of the right axis</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reference data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>largest error: number with unit, quantity</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max </source>
        <comment>largest error, before the numbers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing to compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file&apos;s rounding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference is 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no percentage, the reference is 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error of %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>textbook&apos;s θ₃ = θ³ + 180° = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference: %1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::PlotGrid</name>
    <message>
        <source>Plots of the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coupler angle θ³ over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider position R_x⁴ over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of the positions over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coupler angular velocity dθ³/dt over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider velocity dR_x⁴/dt over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of the velocities over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coupler angular acceleration d²θ³/dt² over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider acceleration d²R_x⁴/dt² over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of the accelerations over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No reference data.&lt;br&gt;&lt;a href=&quot;open&quot;&gt;Open a reference…&lt;/a&gt;&lt;br&gt;or drop a CSV here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all &amp;nine plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Maximize this plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;whole run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy this plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export this plot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error in &amp;% of the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error in ° and &amp;mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error in % of the &amp;peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Logarithmic errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File&apos;s &amp;rounding as a band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over the crank &amp;angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mea&amp;suring cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A %1 s · B %2 s · B − A = %3 s</source>
        <comment>instants of the measuring cursors</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> = %1° of the crank</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::ReferenceFileText</name>
    <message>
        <source>%1, line %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, line %2, column %3 (&quot;%4&quot;): %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a folder: choose a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::ReferencePanel</name>
    <message>
        <source>Reference: what was read, and how</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a simulation&apos;s exported motion (CSV): here it says what was read from the file and how, which mechanism the motion belongs to, and by which other reading it would come nearer. A file can also be dropped anywhere in the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion that the report&apos;s author exported from Inventor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose columns…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say what the columns of the file are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose motion the file is, and how else it may be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rounded to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of the file, a row a column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the file rounded this column, inferred from all its values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>why it was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows of the file that were left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, t = %1 … %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, 1 gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows left out (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read otherwise than printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read as printed again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How else it may be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose motion it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being found out…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes this mechanism the one on show; can be undone</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::Report</name>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coupler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin: the linkage as the file has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference: %1, t = %2 s to %3 s, %4 instants.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows, the first in line %2 (&quot;%3&quot;: %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the columns %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left out of the file: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file&apos;s step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 instants from t = %2 s to %3 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed form, exact to rounding. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until the residual ‖C‖ no longer falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until ‖C‖ ≤ %1 (absolute, mm and rad as they are)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>until ‖C‖ ≤ %1 (relative, lengths divided by a + b + |c|)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton-Raphson in the 12 absolute coordinates, %1, at most %2 iterations an instant. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It took %1 iterations in all, %2 an instant at most; the largest residual is %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %1 of %2 instants are solved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Against its own mechanism the file agrees in %1 of %2 channels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found by weighted least squares (Levenberg-Marquardt, %1 iterations, condition number %2); ± is one standard deviation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file was read with the conventions named above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors: model against reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest error: max |model − reference|. Largest %: max |model − reference| / |reference| · 100 where the reference is not zero. File&apos;s step: distance of the numbers that the file can print, where it is largest. To the last printed digit: at least %1 % of the values within half a step, none beyond %2 halves. Within n × the file&apos;s rounding: none beyond n half steps, n ≤ %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of an offset slider-crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion and errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::ReportPages</name>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::SceneFile</name>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what you changed as a scene?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::SceneText</name>
    <message>
        <source>%1: &quot;%2&quot; must be %3. Correct it there, or open another scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is missing. Add it there, or open another scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number of a magnitude up to 1e12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number greater than 0 and at most 1e12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number not less than 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from 1 to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>true or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text in quotation marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object in braces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list in brackets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two numbers in brackets, the smaller one first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;time&quot;, &quot;ignored&quot; or a channel such as &quot;theta3&quot; or &quot;R4_x_diff&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of channels such as &quot;theta3&quot; or &quot;R4_x_diff&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of two channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, line %2: this is not JSON (%3). Correct it there, or open another scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no scene: it has no &quot;version&quot; that is a number. Open a file that this program saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was saved by a newer slidercrank (scene version %2, this one reads up to %3). Open it with that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a folder: choose a scene&apos;s file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no scene: it is too large. Open a file that this program saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another name or folder.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::Session</name>
    <message>
        <source>%1 must be a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must not exceed %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be greater than 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taking over the file&apos;s mechanism</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::StudyFigureText</name>
    <message>
        <source>time per state [ns]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest error / peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton dense (report)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton dense, Taylor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton structured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton structured, Taylor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed form, batch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 harmonics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, tolerance %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ns per state (± %2), %3 channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 iterations per state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest error %1 of the peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no instant solved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rounded input alone makes κ·u = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ·u</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::StudyPanel</name>
    <message>
        <source>solved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>singular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not converged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not assemblable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not finite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 silently wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a = %1 mm, b = %2 mm, c = %3 mm, ω₂ = %4 rad/s, θ₂₀ = %5 rad, %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed and accuracy of the methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run (this mechanism)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times every method on one turn of this mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run hard cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toggles, rockers, other scales, far times: takes some ten seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Case on show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture as PNG, SVG or PDF, the numbers as CSV or JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Methods, a row a method and tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the motion is computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of Newton-Raphson: absolute as in the report for its own way, relative for the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time per state: median over interleaved rounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worst of the six plotted channels, relative to the channel&apos;s peak, over solved instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ·u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The error that rounding the given numbers makes by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Per state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the method says of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, nothing silently wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, ⚠ %1 instants silently wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, done in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (cancelled)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>. The mechanism has changed since: run again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>. Times of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to export yet: run the study first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed and accuracy: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed.png</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images and drawings (*.png *.svg *.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed.csv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv *.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::StudyPicture</name>
    <message>
        <source>Error against time per state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best in speed and error: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast is each method, and how exact? Run the study: every method is timed on the same instants and its error measured against 50 digits and more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>slidercrank::Timeline</name>
    <message>
        <source>%1×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instant in seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle: type one to go where the crank first passes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instant, slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>θ₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
