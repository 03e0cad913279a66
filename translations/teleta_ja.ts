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
    <name>BakeText</name>
    <message>
        <source>the pattern has too many corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 breakpoints</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Bracelet</name>
    <message>
        <source>The connection to the bracelet was lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a USB device %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a USB device %1 with the serial number %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bracelet is plugged in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device does not answer as a bracelet does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a feature report of layout version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet at %1 may not be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read and write access to it, which the udev rule gives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet at %1 cannot be opened.</source>
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
    <message>
        <source>View of the Operate page to bring to the front: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--dock %1: expected one of %2</source>
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
    <name>ContourCommand</name>
    <message>
        <source>circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (confidence %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 1/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m (points off by %2 m)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape, vertices and spline of a series of contact points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV with the columns x_m,y_m, in the order of touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>approximating: the points are the control points; interpolating: the curve passes through them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contour comes back to its start; otherwise this is found out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of the curve, for the CSV and the largest curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An extent under this is a point, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the curve as CSV t,x_m,y_m,curvature_per_m, t from 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coordinate is too large to compute with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a row for each contact point, in metres</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ContourPicture</name>
    <message>
        <source>nothing explored yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, confidence %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch an object from several sides: its outline appears here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edges %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points off by %1 (rms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y [mm]</source>
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
    <message>
        <source>text outside of the quotes of a value</source>
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
    <name>DevicesCommand</name>
    <message>
        <source>&quot;kind&quot; is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind = &quot;modbus&quot; or &quot;wts&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tactile array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modbus device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not connected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to %1 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No device is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is connected, why not, and how fast it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to the device of this description and read it; its motors are set to zero</source>
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
    <name>FigureText</name>
    <message>
        <source>Subject response, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actual pattern</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>the ending of the name tells no format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of %1</source>
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
    <name>GaugeTexts</name>
    <message>
        <source>no stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken as %1, level %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, level %2, not certain</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 %: %1   %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not told from rigid   %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no interval known   %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffer than the link allows: check contact distance and link stiffness.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level %1, %2, the paper&apos;s object %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rigid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: from %2
%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: under %2
%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 to %3
%4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stiffness. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no touch yet</source>
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
    <name>Modbus</name>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device has no motors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a table [tactors] in its file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device tells no joints.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>four tables [[joint]] in its file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>illegal function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>illegal data address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>illegal data value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>device failure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>device busy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>negative acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>memory parity error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gateway path unavailable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the device behind the gateway does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in the standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server answered with exception %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server did not answer in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s answer does not fit the request.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection was lost.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Mouse3d</name>
    <message>
        <source>The 3D mouse at %1 may not be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read and write access to it, which the udev rule gives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 3D mouse at %1 cannot be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No 3D mouse is plugged in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 3D mouse was unplugged.</source>
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
    <name>PatternCommand</name>
    <message>
        <source>shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>-</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>static</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>... (%1 breakpoints)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tactor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List, show, sample, convert and check the patterns of the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern file or id of a built-in pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List the built-in patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what a pattern consists of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample a pattern: rows time_s,t1..t6 over its duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the motors will do, with an assumed motor: lag, start and speed are not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a pattern in another format, told by the ending</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File to write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say where a pattern breaks a law of what can be felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ending of %1 tells no format; expected one of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 keeps all laws.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 s to %3 s: %4 %5</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PatternFile</name>
    <message>
        <source>the pattern cannot be stretched like that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a factor above 0 with which it lasts at most a day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the times go back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a time that is not before the one in front of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no tactor for the file &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>files tactor1.haptic to tactor6.haptic, each once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a pattern cannot hold this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the times go back or on for too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no tactor left for this channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>six channels with directions 60 degrees apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is another format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is of a newer version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these values contradict each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a start between 0 and 1, times above 0, a curve that rises from the start or before it to the drive 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file or built-in pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a pattern file, or an id of teleta pattern list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this format holds one tactor, the pattern uses more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name that ends with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>patterns are written in this format, but not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this name is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pattern is too long for a WAV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a time that is not before the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this effect is for other devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the zip archive has too many files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the unpacked zip archive is too large</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PatternJson</name>
    <message>
        <source>the file is too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the values are nested too deeply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object has the key &quot;%1&quot; twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each key once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the JSON text is damaged or cut off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON in UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with the key &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an array of length %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an array of length %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the array has a wrong length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not an array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is neither true nor false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PatternLaws</name>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A burst of %1 is too short for the motor, which needs %2 to rise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A turn of the ring takes %1; its direction is felt reliably from %2 on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bursts begin %1 apart; they are felt as one motion with %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object %1 plays on the same motor at the same time (tactors %2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tactors %1 are at most %2 Hz apart in speed: they beat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It goes on until %1 s, but the pattern ends at %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the ring %1 turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it %1 long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the ring %1 long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the law of apparent motion set them %1 apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let it begin at %1 s, when the other one is over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give both the same intensity, or make them %1 Hz different.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the pattern last %1 s.</source>
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
    <name>ProtocolText</name>
    <message>
        <source>&quot;%1&quot; cannot be part of a file name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>letters, digits, - and _</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each one once</source>
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
    <name>RegisterMapReader</name>
    <message>
        <source>&quot;scale&quot; is 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the value of one count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last register would be beyond 65535</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an address of at most %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not fit into the register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value that type, scale and offset can express</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;full&quot; and &quot;off&quot; are the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value at which the motor runs as fast as it can</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a float has no bits to look at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no input &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of an [[input]]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the unit of &quot;%1&quot; is &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an input in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name of its own for each input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of joints is wrong: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, from the shoulder on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the watchdog is a register of a motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a register of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no motor to watch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a table [tactors]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file names no register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[tactors] or [[input]]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no such device comes with the program</source>
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
    <message>
        <source>a property of the arm is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a property of the joint controllers is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a property of the arm&apos;s skin is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a property of object &quot;%1&quot; is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program of the arm is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>effect &quot;%1&quot; needs an arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene is that of an arm, not of a tactile array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene is that of a tactile array, not of an arm</source>
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
    <message>
        <source>the arm starts outside the range of its joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the waypoints are not in the order of time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program has no object to touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least one [[object]]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SceneRun</name>
    <message>
        <source>the folder cannot be made or written to</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SimulateCommand</name>
    <message>
        <source>Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computed in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s (%2 x real time)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run a simulated scene as fast as possible and measure what was estimated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of all random numbers of the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated time in seconds; otherwise what the scene says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for summary.json and the recorded data as CSV</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SimulatedArmDevice</name>
    <message>
        <source>The arm was unplugged.</source>
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
    <name>SimulatedBracelet</name>
    <message>
        <source>Simulated bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet was unplugged.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>these are data of different modes: %1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one mode, or to be told which one counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;</source>
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
    <name>StoreText</name>
    <message>
        <source>the study is damaged: a session or a trial has a number that its protocol does not have</source>
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
    <name>StudyCommand</name>
    <message>
        <source>%1 % correct (95 %: %2 to %3, %4 participants)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % correct (one participant)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bit, %2 without bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F(%1, %2) = %3, p = %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rehearse a user study with simulated participants, and analyse studies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run simulated participants through a whole study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocol of the study; otherwise the paper&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many take part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of all orders and answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the trials in which nothing is answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the new study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with a rehearsal that was interrupted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confusion matrices, accuracy, information transfer and ANOVA of studies or trial CSVs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folders of studies, or CSVs with participant_id,task,condition,phase,stimulus,response</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only data of this mode; different modes are not merged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for confusion_long.csv, summary.csv, group.csv and anova.csv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the trials of a study as files into its folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>psychds: data/; bids: bids/; excel: excel/, with semicolons and the decimal sign of the locale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of them kept before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is named twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each study and each file once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are no completed trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trials that were answered or timed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyExport</name>
    <message>
        <source>cannot make the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file does not hold what was written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyFigure</name>
    <message>
        <source>cannot make the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two figures have the same name</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyFiles</name>
    <message>
        <source>cannot make the folder</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyProtocol</name>
    <message>
        <source>&quot;%1&quot; means no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another letter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open the protocol: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyRehearsal</name>
    <message>
        <source>this study has real participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a study that was begun as a rehearsal</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudySchema</name>
    <message>
        <source>this is no study: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a newer program made this study (schema %1, this one knows %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write the study: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudySession</name>
    <message>
        <source>the trials that were kept are not those of this plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the order that the seed of the session gives</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyStore</name>
    <message>
        <source>cannot open the study: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot use the study: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot make the folder of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a study in this folder already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a new folder, or to go on with the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no study here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a folder with study.sqlite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the study was never completely made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text of 1 to %1 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the participant &quot;%1&quot; is enrolled already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this trial is kept already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each attempt of a trial once</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyTrialSource</name>
    <message>
        <source>run, pilot or simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>practice or test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correct, incorrect, timeout, aborted or device_error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what stimulus and response say</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number of seconds or NA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are too many different patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ease in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ease out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ease in and out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1 at %2°
%3 s: %4 %, %5 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 to %3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste in Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste at Play&amp;head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>commanded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>predicted (assumed motors)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>predicted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor cannot follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom in to see what the motors do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phantom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse train</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke</source>
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
    <name>TouchTexts</name>
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
        <source>circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SAFE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DANGER</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>regression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The readings of angle or torque are not usable numbers. Check the arm&apos;s sensors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contact lies on the joint&apos;s axis, or the link&apos;s stiffness is not set: nothing to divide by.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise of the arm&apos;s readings is set below zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The torque window is empty: its upper end must lie above its lower end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No joint samples came in during the touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The touch was too light: the torque did not reach the torque window. Press harder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The touch was too quick: fewer than two samples lie in the torque window. Press slower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The torque did not change within the torque window. Press with rising force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The joint turned against the rising torque: the object moved, or a sign is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shoulder roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1 (95 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 … rigid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 … %2</source>
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
    <name>WtsDevice</name>
    <message>
        <source>a serial port cannot run at %1 baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a serial port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot find %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connecting was cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot connect to %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link failed: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sensor closed the connection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device was unplugged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sensor says that it has %1 rows and %2 columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an array of 1 to %1 rows and columns whose frame fits into one message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sensor&apos;s cells are %1 mm wide and %2 mm high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sensor describes its array in %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the 10 bytes of a WTS array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sensor sends no frames: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sensor does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sensor refused a request: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another array is connected: %1 x %2 cells of %3 mm instead of %4 x %5 cells of %6 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sensor has sent no usable frame for %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WtsText</name>
    <message>
        <source>&quot;%1&quot; is not the address of a tactile array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the path of a serial port, or tcp://HOST:PORT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>success</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not available</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sensor connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not initialised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>already running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not supported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inconsistent data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time-out in the sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read error in the sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write error in the sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>access denied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>status %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ZipText</name>
    <message>
        <source>the zip archive is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a zip archive that is not encrypted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the zip archive could not be made</source>
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
    <name>teleta::bracelet::BraceletView</name>
    <message>
        <source>Bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;What the six motors of the bracelet do now, on the unrolled forearm: from left to right once around the arm. The fuller a disc, the stronger the motor vibrates.&lt;/p&gt;&lt;p&gt;Where a bracelet is connected, hold a disc with the mouse, or one of the keys 1 to 6, to feel that motor alone.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motor %1: %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is played</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1 at %2°: %3 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointChartView</name>
    <message>
        <source>Joint torques and angles of the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Torque of each joint over time. The coloured band is the torque window: between its ends a touch is evaluated. Grey stretches are touches with their numbers, from the first torque above the noise to the estimate.&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No arm. Open a scene or a device with an arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the joint angles too</source>
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
        <source>at %1 s   arm time %2 s</source>
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
        <source>joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;pan</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointPlot</name>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shoulder roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint angle</source>
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
    <message>
        <source>touch to skin %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the completed touch to the first frame of its pattern: %1 ms</source>
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
    <name>teleta::console::ArmViews</name>
    <message>
        <source>%1 (%2 %)</source>
        <comment>a recognised shape and its confidence</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::BraceletStation</name>
    <message>
        <source>STOP is engaged: the bracelet is off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bracelet: what would be played is named in the table of patterns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting to the bracelet…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet is not connected. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::FeedbackPanel</name>
    <message>
        <source>shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>static</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no pattern</source>
        <comment>what was recognised</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch %1: %2. There is no pattern for it in the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was felt %4 later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness and shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What of a touch is played on the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
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
    <message>
        <source>Demo: an arm touches five materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sponge, rubber sponge, rubber, wood and metal: contact point, force, stiffness, bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: an arm explores a round object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The forearm touches it from all around: contact points, spline, recognised shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: an arm explores a rectangular object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same with a box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: an arm explores a triangular object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same with a triangular prism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: an arm yields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody pushes the arm, then it meets an object, under joint admittance control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: a pressure mat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A 64 x 27 mat under a body: a head, a trunk that turns, two heels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run its program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin &amp;anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is touched from now on is another object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;USB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::OperateDocks</name>
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
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contour</source>
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
    <message>
        <source>joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet could not be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulated arm that touches five materials</source>
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
    <name>teleta::editor::PatternDocument</name>
    <message>
        <source>%1 (copy)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Breakpoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Breakpoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set Breakpoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale Intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stretch in Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete Breakpoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap Arms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the Law</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change Task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change Duration</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::editor::TimelineView</name>
    <message>
        <source>Time in s; intensity in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timeline of the pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Six motors over time. The blue line is what is asked of a motor, the thin one what the motor is predicted to do; it is hatched where the motor cannot follow.&lt;/p&gt;&lt;p&gt;Double-click or &lt;b&gt;P&lt;/b&gt;: add breakpoints. Drag: move, with &lt;b&gt;Alt&lt;/b&gt; off the grid. Drag on the ground, or with &lt;b&gt;Shift&lt;/b&gt;: select. Double-click on a breakpoint or &lt;b&gt;Enter&lt;/b&gt;: type its numbers. Arrow keys: move what is selected, with &lt;b&gt;Shift&lt;/b&gt; farther in time and finer in intensity. &lt;b&gt;Page Up&lt;/b&gt;, &lt;b&gt;Page Down&lt;/b&gt;: lane; &lt;b&gt;,&lt;/b&gt; and &lt;b&gt;.&lt;/b&gt;: breakpoint; &lt;b&gt;Insert&lt;/b&gt;: a breakpoint at the playhead.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; and wheel: zoom. &lt;b&gt;Shift&lt;/b&gt; and wheel: scroll. On the ruler a drag moves the playhead and, with &lt;b&gt;Shift&lt;/b&gt;, sets the loop.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Type Numbers…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;Breakpoint Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Zoom to Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear &amp;Loop</source>
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
    <name>teleta::touch::ContourView</name>
    <message>
        <source>Explored contour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;The object from above, as far as it was explored: the points at which it was touched, the spline through them, and the vertices or the circle of the shape that was recognised.&lt;/p&gt;&lt;p&gt;The confidence is that of the decision between the known shapes.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::touch::DriveSign</name>
    <message>
        <source>Drive of the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no arm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::touch::JogPanel</name>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Moves the arm by hand. It moves only while you hold Shift, or the wide button, together with a direction. Let go of either and it stands still.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the arm&apos;s program go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the arm where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;estart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin the arm&apos;s program anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip, x y z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn single joints, or move the tip of the forearm along the base&apos;s axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the fastest speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold to enable (or Shift)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead-man switch: the arm moves only while this button or Shift is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead-man switch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tip along %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold with Shift to move; key Shift+%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No arm is connected. Open a scene or a device with an arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP is engaged. Hold the STOP button to release it, then jog.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with D A (x), W S (y), E Q (z).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with Q W E R (up), A S D F (down).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::touch::JointRange</name>
    <message>
        <source>Range %1° … %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::touch::PatternMapTable</name>
    <message>
        <source>level %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was recognised and its pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Which pattern the bracelet plays for what was recognised. The marked row was recognised last.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns for what was recognised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
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
        <source>&amp;Defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The built-in dynamic patterns again; can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (now)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recognised: %1. Nothing is played.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recognised: %1. Pattern now: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recognised: %1. Its pattern %2 is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file could not be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map of patterns (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::touch::StiffnessGauge</name>
    <message>
        <source>Stiffness of the touched object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;How stiff the object is that was touched last, on a logarithmic scale. The dot is the estimate, the line through it the interval in which the stiffness lies with 95 %.&lt;/p&gt;&lt;p&gt;An object that yields hardly more than the arm itself cannot be told from a rigid one: then an open arrow shows that its stiffness is at least so large.&lt;/p&gt;&lt;p&gt;Sponge and rubber sponge are safe to touch; rubber, wood and metal are a danger.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch an object with the forearm: its stiffness appears here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchModel</name>
    <message>
        <source>No force: the skin did not feel where the contact is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 ± %3 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not observable in this configuration of the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>condition number %1, unexplained torque %2 Nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>95 % interval in brackets; %1, %n sample(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>No stiffness: the skin did not feel where the contact is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (not certain), %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First torque above the noise at %1 s, estimated %2 ms later; evaluated: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x, y, z in the frame of the arm&apos;s base; the distance is along the forearm, from the elbow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The skin did not feel this contact.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force at the contact; ? marks what the arm cannot observe in its configuration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition number of the force: longest over shortest lever; large is bad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the contact from the elbow, along the forearm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact x, y, z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force x, y, z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchTable</name>
    <message>
        <source>Recent touches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Every touch of the arm with what was found out about it. A ? in the force marks a component that the arm cannot observe in its configuration.&lt;/p&gt;&lt;p&gt;Click a title to sort. Ctrl+C copies the selected rows.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No touch yet. Touch an object with the forearm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>touches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Newest First</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n touch(es)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
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
