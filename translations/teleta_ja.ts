<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>TeleTA Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows, and lets the operator feel, what a remote robot arm touches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About TeleTA Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc Esc, Ctrl+.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP: whatever moves stops at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Operate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause, in the playback bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One frame back or forward, in the playback bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start or end of the recording, in the playback bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the read-out from taxel to taxel, in the heatmap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom the picture or the time under the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scroll through time, in the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1, 2, 3, 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front, top, side, isometric view, in the reconstruction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What&apos;s This</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Age</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ConsoleOptions</name>
    <message>
        <source>--%1 %2: expected a number from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 %2: expected a whole number from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what a remote robot arm touches: where, how hard, how stiff, what shape.

Examples:
  teleta-console --scene resources/scenes/tactile-indenter.toml
  teleta-console --replay run.csv --rows 64 --columns 27 --tare empty.csv --threshold 10
  teleta-console --sources both-arrays.toml --theme dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a simulated scene (repeatable).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FILE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the simulated scenes (default 1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play back recorded frames, CSV time_s,t0,t1,... (repeatable; the options below go with the recordings in their order).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows of the array (default: by the number of taxels).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of the array.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between taxels in mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording of the unloaded array, subtracted from the frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values fall under load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load per raw unit (default 1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>G</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of the loads (default N or counts, by the array).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NAME</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact (default 0.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LOAD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play at this rate in Hz instead of the recorded times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the sources listed in a TOML file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page to show: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light, dark or system.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language, for example en, ja, fr, zh_CN.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CODE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a picture of the window as PNG and quit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds to wait before the picture (default 3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the window, for example 1600x1000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WxH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run for so many seconds, print how long the event loop was busy, quit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with the default layout and settings, and save none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--page %1: expected one of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--theme %1: expected light, dark or system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--size %1: expected WIDTHxHEIGHT, from 320x240 to 16384x16384</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ContactsCommand</name>
    <message>
        <source>Place, force and identity of each contact of each tactile frame</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CsvReaderText</name>
    <message>
        <source>opening was interrupted: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open the file: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a CSV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a header line with the names of the columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is UTF-16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text outside of the quotes of a column name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comma behind the closing quote</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line is longer than 16 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a closing quote</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a quote is not closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number, nan, inf or NA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the column %1 is there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each name once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing columns: %1; the file has: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the columns %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the row is too long: more than %1 values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one value a column: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the row is too short: %1 of %2 values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a pipe has no positions to go to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DeviceState</name>
    <message>
        <source>closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connecting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reconnecting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finished</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source> (expected %1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FeaturesCommand</name>
    <message>
        <source>Force, centres, moments and orientation of each tactile frame</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FigureExport</name>
    <message>
        <source>The file could not be written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown picture format &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FrameFileText</name>
    <message>
        <source>column %1 is &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are no taxel columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the columns time_s, t0, t1, ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file has %1 taxel columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2 rows x %3 columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least one row behind the header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the time is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a finite time in s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the time goes back from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FrameOptionText</name>
    <message>
        <source>%1 is given, a taxel from 0 to %2 is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded frames: time_s,t0,t1,... with one row a frame, row-major</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows of the array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of the array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of neighbouring taxels in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load in N from which a taxel is in contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames of the unloaded array; their mean is subtracted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The raw values fall under load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N per raw unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers of taxels to leave out, such as 0,17</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight the taxels with their load to find the principal axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find the threshold in each frame; --threshold is the least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force and centre of pressure over taxels in contact, not over the whole array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Summits that rise less than this share of the frame&apos;s peak are no contacts of their own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contacts of fewer taxels are dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the output would replace the input</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HeatmapPainter</name>
    <message>
        <source>x [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre of pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre of contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dead %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point at a taxel to read it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HeatmapView</name>
    <message>
        <source>dead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact #%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row %1, column %2   %3   %4   x %5 mm, y %6 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Interruption</name>
    <message>
        <source>interrupted; the output ends with what was computed until then</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OutputFileText</name>
    <message>
        <source>cannot write: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard output</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OutputText</name>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OverlayMaker</name>
    <message>
        <source>%1: %2</source>
        <extracomment>A contact in the 3-D view: its number and its force</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each block: the largest of %1 × %1 taxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder enlarged to fit: radius %1, length %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder: radius %1, length %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest arrow: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Usage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OPTIONS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(required)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print this help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>teleta: %1
%2 --help says more.
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computes contacts, stiffness and shape from what a tactile robot arm has felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print the version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Example:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Provenance</name>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReplayDevice</name>
    <message>
        <source>only a file can be played, not a pipe</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>the frame rate of the scene is not a positive number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the size of the tactile array is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a property of the tactile array is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the size of indenter &quot;%1&quot; is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motion of indenter &quot;%1&quot; is not a series of rising times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a parameter of effect &quot;%1&quot; is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>effect &quot;%1&quot; is listed twice</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SceneReader</name>
    <message>
        <source>the keyframes are not in the order of time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a time after %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motion does not end where it starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a last keyframe like the first one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which taxels are dead is not clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>either &quot;count&quot; or &quot;taxels&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the effect is listed twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each effect at most once</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SimulatedArrayDevice</name>
    <message>
        <source>The device was unplugged.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StiffnessCommand</name>
    <message>
        <source>sponge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rubber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1 N/m (95 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N/m (uncertainty not available)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N/m (95 %: %2 to %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>regression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque rise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Total stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, safe to touch, level %2 of 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, danger, level %2 of 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness and material of an object from joint angle and torque during a touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV with the columns time_s,joint_angle_rad,joint_torque_nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the contact from the joint&apos;s axis along the link, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the thickness of the link, m; it cancels out of the stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link&apos;s own stiffness, N/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-point: the samples nearest to both borders of the window; regression: all samples in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torques between which the touch is evaluated, Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 or more is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a lower border of 0 or more and a higher upper one are expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the touch is stiffer than the link allows: check contact distance and link stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the log has no samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a row for each sample of the touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one half of the torque window has no sample; the largest torque is %1 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples near %1 Nm and near %2 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sample reaches the torque window; the largest torque is %1 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>torques from %1 to %2 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only one sample lies in the torque window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two or more samples from %1 to %2 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the torque does not change within the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>torque that rises from %1 to %2 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the joint turns against the rising torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle and torque that rise together; the sign of one column may be turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the numbers are too large or too small to compute with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SI units</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DZMP</source>
        <comment>deviation of the zero moment point: centre of pressure minus centre of contact</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread</source>
        <comment>standard deviations of the touched area along its principal axes</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge ratio</source>
        <comment>ratio of the eigenvalues of the touched area</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Active taxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>threshold</source>
        <comment>of one taxel</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoP</source>
        <comment>centre of pressure</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoC</source>
        <comment>centre of contact</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>active</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TomlReader</name>
    <message>
        <source>one of: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number above %1, at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number above %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number of at most %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number or nan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong type for &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no unit in its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has another unit in its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; perhaps &quot;%2&quot; is meant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a TOML file that can be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not valid TOML: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>true or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;; perhaps &quot;%3&quot; is meant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a table: [%1]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tables: [[%1]] or %1 = [{...}]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has too few entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ValidatorText</name>
    <message>
        <source>%1 is given, %2 is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::base::FigureExport</name>
    <message>
        <source>&amp;Copy Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy &amp;Data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Da&amp;ta…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG picture (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::charts::StripChartView</name>
    <message>
        <source>Strip charts of the tactile features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Force, centres, moment deviation and orientation of the contact over time. The numbers beside the strips are the newest values, or those at the cursor.&lt;/p&gt;&lt;p&gt;A line that stops and goes on means that nothing is known in between: the contact was gone, samples were lost, or the recording jumped (dotted line).&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its ends.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose which strips are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show %1 s (Ctrl+wheel for other spans)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go Live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the picture; samples go on being kept (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark this moment (M)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 s   stream time %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 s   no sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PAUSED, %1 s behind   %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Type Range of %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Automatic Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends of the axis of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower and upper end, for example -5 5. Empty: automatic.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::charts::StripPlot</name>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::chrome::DeviceStrip</name>
    <message>
        <source>Devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <comment>state of a device and its age</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lost</source>
        <comment>frames</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to screen %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate: %1 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames lost: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames displayed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Age of the newest frame: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the read to the screen: %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageBar</name>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n older message(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>since %1, %n times</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Hide details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::chrome::PageRail</name>
    <message>
        <source>Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <comment>tool tip of a page and its shortcut</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::chrome::PlaybackBar</name>
    <message>
        <source>%1 / %2</source>
        <comment>time and duration</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playback</source>
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
        <source>One frame back</source>
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
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::chrome::SourceChooser</name>
    <message>
        <source>%1 (opening…)</source>
        <comment>a source</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>a source and whether its data are simulated or recorded</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded frames as CSV: time_s,t0,t1,…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;scene file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tactile array that the views show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a simulated scene or a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this source</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::chrome::StopButton</name>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold to release</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything that moves is stopped. Hold for a second to release.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops everything that moves at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop everything that moves at once (Esc Esc, or Ctrl+.)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::MainWindow</name>
    <message>
        <source>TeleTA Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the arm touches, live or played back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded frames (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open source list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source lists (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: a ball and a bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A 6 x 14 array pressed by a ball that wanders, then by a bar that turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: two contacts that meet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two balls that approach each other until they touch, and part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the source that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
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
        <source>As the &amp;desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About TeleTA Console</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::OperatePage</name>
    <message>
        <source>Choose another folder or file name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was lost.</source>
        <comment>a source</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What came before the damaged place can still be played. Repair the file and open it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the cable and the power supply; it is tried again by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heatmap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a demo scene to look around, a recording, or a list of sources.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;demo scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulated tactile array that is touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded frames as CSV: time_s,t0,t1,…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A TOML file that lists scenes and recordings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingDialog</name>
    <message>
        <source>The &amp;values fall under load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start &amp;again at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the recording of the unloaded array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows ×</source>
        <comment>N rows x M columns</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Array:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pitch:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unloaded (tare):</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of the &amp;load:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Threshold:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n taxel(s), as in the file</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 taxels, but the file has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording of the unloaded array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::Unattended</name>
    <message>
        <source>teleta-console: %1: cannot write the picture: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::tactile::ChannelSettingsPanel</name>
    <message>
        <source>Not tared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tared</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Tared, %n taxel(s) without a reading</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Tare now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the mean of the next half second as the unloaded state. Nothing may touch the array.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear tare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uses the raw values again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load per raw unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values &amp;fall under load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For arrays whose raw values are highest when nothing touches them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;hreshold:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A taxel is in contact from this load on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Automatic threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds the lowest useful threshold in each frame; the value above is its lower bound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Noise height:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two summits are one contact when the lower one rises less than this above the saddle between them, in percent of the frame&apos;s peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Smallest contact:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In taxels; contacts of fewer are ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Orientation:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which taxels the principal axis is computed from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>active taxels alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weighted with the load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Force over:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole image counts every load; active taxels leave out the noise of unloaded ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whole image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>active taxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edge above:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contact becomes an edge when the ratio of the eigenvalues rises above this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Point below:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contact becomes a point when the ratio of the eigenvalues falls below this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default values for everything but the tare</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::tactile::HeatmapView</name>
    <message>
        <source>Tactile heatmap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;The load of every taxel of the array, seen from outside the skin: x points to the right, y up.&lt;/p&gt;&lt;p&gt;Coloured outlines are contacts, each with the number under which it is followed. × is the centre of pressure, ○ the centre of contact, the line the principal axis. Hatched taxels are dead and carry no load.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, drag moves, double click shows the whole array. Double-click the colour bar to type its upper end. The arrow keys read taxel by taxel.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline each contact and show its number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of &amp;Pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the load-weighted centre with ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of C&amp;ontact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the centre of the touched area with ○</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Principal &amp;Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the axis along which the touched area is longest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write each load into its taxel where there is room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heatmap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour &amp;Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fixed at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Type Upper End…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;Whole Array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper end of the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load at the upper end of the colours. Empty: automatic.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads from 0 to %1. Taxels under the threshold of %2 carry no contact.
Double-click to type the upper end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead taxel: its value is not used.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::view3d::Scene3dView</name>
    <message>
        <source>touch 3-D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the array flat, as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrapped on the cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrap the array around the tactile cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the start: everything from a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the strongest contact in the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel lines stay parallel: no perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the ground with a grid in millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the axes of the array&apos;s frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show how far each contact moved since it began</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show number and force at each contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export geometry…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene for other programs: VTP, PLY, STL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch in 3-D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tactile array with its loads as heights and colours, contacts with force arrows, the arm and the explored contour. Drag with the left button to turn, with the middle button to move, turn the wheel to zoom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No touch to show yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export geometry (in mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VTK, with colours and lines (*.vtp)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangles with colours (*.ply)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangles (*.stl)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact %1
Force %2, peak %3
x %4, y %5
Area %6</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::view3d::VtkWidget</name>
    <message>
        <source>No 3-D view here. %1
All other views work without it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view3d</name>
    <message>
        <source>This is no geometry format that can be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file name that ends in .vtp, .ply or .stl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene is empty: there is nothing to write.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The geometry could not be written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The display platform &quot;%1&quot; has no OpenGL widgets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This display offers no OpenGL %1.%2 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This display refused an OpenGL context.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The OpenGL driver of this display does not work with VTK.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
