<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>AblationText</name>
    <message>
        <source>interrupted before all runs were done</source>
        <translation type="unfinished"></translation>
    </message>
</context>
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
    <message>
        <source>Space, P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause; pen; in the timeline of a pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+N, O, S, Shift+S, E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New, open, save, save as, export, on the page Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo, redo, on the page Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+X, C, V, Shift+V, D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut, copy, paste in place, paste at the playhead, duplicate, in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>,  .  with Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Breakpoint before or after, one more of them, in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N, Shift+N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next or previous object, in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter, Insert, Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type numbers, add a breakpoint at the playhead, delete, in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys, with Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move what is selected, else the playhead and the lane, in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[  ]  \</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin of the loop, its end, no loop, in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+[, Ctrl+], Ctrl+M, Ctrl+L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate around the ring, mirror, other arm, on the page Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Alt+1 to 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a sweep, ring, phantom, ramp, pulse train at the playhead, on the page Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl++, Ctrl+-, Ctrl+0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in, out, to fit, in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F2, Ctrl+D, Delete, Ctrl+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename, duplicate, delete, undo, in the library of patterns</source>
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
    <name>BraceletStimulus</name>
    <message>
        <source>%1, ready</source>
        <comment>bracelet</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, ready; last stimulus: %2 frames, longest write %3 ms, %4 late, %5 lost</source>
        <comment>bracelet</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bracelet was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bracelet did not begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something else used the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bracelet: this rehearsal runs too fast to be played</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CalibrateCommand</name>
    <message>
        <source>Pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D to 2D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 px on average, %2 px rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm on average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm of a point on the surface, by the camera alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valid radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Focal lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Principal point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, %3 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrored</source>
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
        <source>Residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neighbours are alike: the pairs hold something that this camera does not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without a pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera and lens of a tactile cylinder from pairs of pixels and points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px,x_m,y_m,z_m, at least 6 rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the image, px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the image, px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the elastomer, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the elastomer, from z = 0 of the sensor frame, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robust: camera and lens, wrong pairs are left out; paper: linear, without a lens, drops pairs that are off by more than 2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the camera to this file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write each pair with what the camera makes of it as CSV</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>The camera gives no frames any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera %1 cannot be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a video, or the number of a camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is no video that can be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a video, a pattern like frame_%04d.png, or the number of a camera</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CameraCalibration</name>
    <message>
        <source>interrupted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file has too many pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CameraFile</name>
    <message>
        <source>this is no camera matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no camera file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is of a newer version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cylinder has no length</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CameraPicture</name>
    <message>
        <source>Contact %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 along the tube, %2° around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard deviation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moved %1 since it began</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>followed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement × %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CameraText</name>
    <message>
        <source>a parameter is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the focal lengths in K are not positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R is no rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the distortion folds on the axis already</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChartText</name>
    <message>
        <source>correct answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correct, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correct answers by pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>response times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median of correct answers, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>information transfer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all patterns told apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less bias</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ConfusionPicture</name>
    <message>
        <source>answered, % of the row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>presented</source>
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
        <source>--dock %1: expected one of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what a remote robot arm touches: where, how hard, how stiff, what shape.

Examples:
  teleta-console --scene tactile-indenter
  teleta-console --replay run.csv --rows 64 --columns 27 --tare empty.csv --threshold 10
  teleta-console --camera 0 --camera-model camera.json
  teleta-console --sources both-arrays.toml --theme dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a simulated scene: a file, or the name of one that comes with the program (repeatable).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SCENE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a camera in the soft tube by its number, or a video of one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FILE|N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration of that camera (JSON of teleta calibrate).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a pattern file, or a built-in pattern by its id, on the Patterns page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of your own patterns (default: the user&apos;s data folder).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FOLDER</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View of the Operate page (%1) or of the Study page (%2) to bring to the front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate the cylinder camera with these pairs (CSV).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder of a study, or a protocol (TOML) to begin one with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PATH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let simulated participants go through the study, which is made if need be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet to drive: simulated, usb, none, or a file that describes a Modbus motor driver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WHICH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--camera and --camera-model belong together: a camera is of no use without its calibration</source>
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
    <name>CostFigure</name>
    <message>
        <source>Median time of one call</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean error (share)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean error (%1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CostFigureText</name>
    <message>
        <source>Filled: no other rung is both as quick and as exact. Lines: to the 95 % error and the 99 % time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured, the machine was too noisy or there is no error: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CostFile</name>
    <message>
        <source>a number that is not negative, or NA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number of samples</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CostFileText</name>
    <message>
        <source>&quot;%1&quot; is no value of the column %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CostLadder</name>
    <message>
        <source>Calibration of the camera in the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of located points of the tube from the true ones; where the calibration is refused the camera of the data sheet stands in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contacts in a camera frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance from the true contact on the tube; a contact that is missed counts with its distance from the tube&apos;s middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve through contact points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of the true outline (circle, rectangle, bent profile) from the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame of the scene &quot;tactile-indenter&quot; without one of its effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference of a taxel from the scene with all effects, root mean square of a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 ms of an arm that touches rubber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest difference of a joint&apos;s torque from a solution with steps of 2 us</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interval of the information transfer of a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>score of the 95 % interval: its width, and 40 times how far the true transfer lies outside of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness of a touched object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the true stiffness of the object; a bound counts as the value, a refused touch as 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of a contact on a tactile array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance from the lowest point of the ball that presses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction in which a pixel of the wide lens looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle from the direction of the point of the tube that the pixel shows</source>
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
    <name>Demo</name>
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
        <source>Demo: a pressure mat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A 64 x 27 mat under a body: a head, a trunk that turns, two heels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: something pokes a soft arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A camera inside the soft tube sees the bump; the arm draws back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: a finger turns a soft arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm turns after a finger that goes round it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: a finger leads a soft arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm follows a finger along its axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Demo: three fingers on a soft arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contacts near the lens, in the middle and at the far end of the tube</source>
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
    <name>EffectAblation</name>
    <message>
        <source>the spread of a measure needs at least two seeds</source>
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
    <name>ExportCommand</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording was cut off; what had been written is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the streams of a recording as CSV files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for a CSV file a stream and events.csv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write over files that are there already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another folder, or --force</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>HJIF (ISO/IEC 23090-31)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One channel a motor, with its place on the forearm. Can be read back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Haptic clips (.haptic in a zip)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One clip a motor. Can be read back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AHAP (in a zip)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file a motor, for Core Haptics.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout of six motors on the forearm, whole milliseconds. Can be read back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns time_s, t1 to t6: a sample a row.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WAV, six channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intensities as 16-bit samples, 1 is full scale.</source>
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
    <name>FeltTask</name>
    <message>
        <source>Motor %1: %2</source>
        <comment>a motor, and what is wrong with the answers</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FeltThreshold</name>
    <message>
        <source>There are too few answers: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes was answered although nothing was presented, %1 of %2 times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes only when something was clearly felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was felt, not even at the highest drive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a connected motor that lies on the skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything was felt, even at the lowest drive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no where nothing was felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The answers contradict each other: stronger was felt less often than weaker, or as often.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answers to what was felt; undo the wrong ones or begin anew</source>
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
    <name>FigureFile</name>
    <message>
        <source>the picture has no size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture would have too many pixels</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>Actual pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot draw the picture: %1</source>
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
    <name>HandStation</name>
    <message>
        <source>3D mouse: none is plugged in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D mouse: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D mouse %1: moves the tip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D mouse %1: hold its first button to move the tip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D mouse</source>
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
    <name>IdentifierText</name>
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
    <name>Interruption</name>
    <message>
        <source>interrupted; the output ends with what was computed until then</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>JsonDocument</name>
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
    <name>LocateCommand</name>
    <message>
        <source>Points on the tactile cylinder that pixels of its camera show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera file that teleta calibrate has written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px</source>
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
    <name>MotorFile</name>
    <message>
        <source>these values contradict each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 &lt; start_drive &lt; full_drive, a curve that rises from the start or before it to the drive 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is of a newer version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are %1 motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the profile is of the bracelet &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MotorFit</name>
    <message>
        <source>The motor started at %1 of the full drive but stood at %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a motor that starts at the same drive each time; look for a loose contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no step: the drive is the same all the time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a staircase of drives from 0 to the full one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The full drive was never commanded: the highest is %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a commanded drive of 0 at its begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is too short: no drive was held for %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a drive that is held until the motor has followed, 0.3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rise time cannot be told: %1 s with a standard error of %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more samples a second, or less noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fall time cannot be told: %1 s with a standard error of %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor does not follow the drive as a motor with a lag: the model explains %1 of the speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a recording of one motor, with the drive of the same time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is too short: %1 samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor does not turn, not even at the full drive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a connected motor, and its sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed is not 0 although nothing is commanded: %1 Hz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sensor without an offset, and a motor at rest at the begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed is clipped: it stays at the end of the sensor&apos;s range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sensor with a larger range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor turned at one level of the drive only: neither its start nor its curve can be told.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drive never falls while the motor turns: the fall time cannot be told.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a step down at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The samples do not tell the motor&apos;s lag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more samples a second during the steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed is saturated: from %1 of the drive on it does not rise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a supply and a sensor that reach the full drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was measured makes no motor: its speed does not rise with the drive.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MotorRecording</name>
    <message>
        <source>The bracelet does not measure its motors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a recording with a sensor of your own, or answers of a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the time does not rise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a time above %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the commanded drive is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a share of the full drive, 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is neither a column &quot;speed_hz&quot; nor &quot;signal&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>times, drives and speeds are not equally many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample %1 is not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1 s with the commanded drive 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The signal is clipped: it stays at the end of its range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a recording with less gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The signal shows no vibration above its noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sensor on the motor, with a signal above four times its noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples a second are too few for %2 turns a second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1 samples a turn</source>
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
    <message>
        <source>%1: ± %2</source>
        <extracomment>A contact on the tube in the 3-D view: its number and the standard deviation of its centre</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>followed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact %1
Force %2, peak %3
x %4, y %5
Area %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tube: radius %1, length %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the skin × %1, fainter where uncertain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipses hold the centres with 95 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PairText</name>
    <message>
        <source>points at several heights and all around the cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coordinate is not a number, or too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finite pixels and metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the image or the cylinder has no size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>positive width, height and radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are too few pairs: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least 6, better 50 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pairs repeat fewer than six different points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least 6 different points, each with its own pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all points are on one line of the cylinder: the camera may turn about that line without a change in the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all points are on one ring of the cylinder: the camera&apos;s distance and its focal length cannot be told apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all points are in one plane: the camera&apos;s distance and its focal length cannot be told apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no camera agrees with enough of the pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half of the pairs and at least %1 in agreement: pixels in the order of their points, the right image size and cylinder radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pairs leave the camera undetermined: points on the surface would be uncertain by more than %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more pairs, spread over the whole surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lens model folds over within the pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more pairs near the lens, where the distortion is strongest</source>
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
    <message>
        <source>List, show, sample, convert, check and play the patterns of the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile of the bracelet&apos;s motors, as the page Calibrate saves it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the motors will do; without --motors with an assumed motor: lag, start and speed are not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples a second of CSV (default 200) and WAV (default 8000)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV and WAV: what the motors will do, with an assumed motor: lag, start and speed are not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play a pattern on a bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>usb, simulated, or a file that describes a Modbus motor driver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play it over and over for so long, then live setpoints for as long again, and print how punctual the frames were</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no samples: --rate and --predicted are for .csv and .wav files</source>
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
    <message>
        <source>the folder cannot be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this format cannot hold another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a pattern file that ends with .json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no recovery file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the key &quot;recovery&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rate of the samples is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the values of a motor contradict each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a WAV file cannot have this rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number of samples a second</source>
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
    <name>PatternPlay</name>
    <message>
        <source>the profile is of the bracelet &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median %1, 99 % below %2, longest %3 us</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet was lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame was so late that the bracelet had stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Hz, achieved %2 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playback thread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deadlines missed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Late by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Setpoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Misses meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshot to frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bracelet answers.</source>
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
    <name>RecordedStreamText</name>
    <message>
        <source>the stream &quot;%1&quot; is not described: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecordedStreams</name>
    <message>
        <source>it is no array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording has no tactile array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a recording of an array or an arm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>block %1 of the stream &quot;%2&quot; is not whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording was never begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stream &quot;%1&quot; is described by &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stream &quot;%1&quot; has %2 columns instead of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a file of this name already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a new name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording cannot be written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a folder that can be written to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a recording of this program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is an SQLite database, but no recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording was made by a newer version of the program (format %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>format %1 or older</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a folder that can be written to: the recording was cut off and has to be completed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording is damaged: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecordingExport</name>
    <message>
        <source>the folder cannot be made or written to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a file of this name already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another folder</source>
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
    <message>
        <source>&quot;start&quot; is not between &quot;off&quot; and &quot;full&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the value of the weakest intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing turns the motors off when the program is killed or the line is cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[watchdog] with the address of the driver&apos;s watchdog register, or with by_traffic = true where it turns them off when nothing is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;answer_timeout_s&quot; is too long for motors: STOP may have to wait for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReplayCommand</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost at this speed</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Play a recording through the processing of a device and print its features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the array&apos;s stream; otherwise the first array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times the recorded speed; otherwise as fast as possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact; otherwise as it was recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording has the arrays %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were not printed</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReplayDevice</name>
    <message>
        <source>only a file can be played, not a pipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReportText</name>
    <message>
        <source>en</source>
        <comment>language of the report, as BCP 47 has it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data: %1. TeleTA Console %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>analysis.R beside this page computes accuracy, intervals and the analysis of variance again from confusion_long.csv: Rscript analysis.R</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ResidualPicture</name>
    <message>
        <source>Image: no pairs yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unrolled cylinder: no pairs yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image: from the pixel to where the camera projects its point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unrolled cylinder: from the point to where its pixel is located</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u to the right, v down, px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle, degrees; z upwards, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrows %1 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x: wrong pair   o: excluded   dashed: valid radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along z −%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ResultsContent</name>
    <message>
        <source>all participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right answers, 95 % Wilson interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right answers, mean of participants, 95 % t interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each pattern: %1</source>
        <comment>conditions</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> against </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p %1%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median response time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median response times, 95 % t interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s from the onset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right answers of the test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % t interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IT bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bias bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IT corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % bootstrap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of the participants&apos; shares of right answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation between participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the mean, from Student&apos;s t over participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of all participants together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information transfer of the pooled matrix, as counted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much it is too high on average: (R-1)(C-1) / (2 n ln 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured less bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the measured transfer, participants drawn with replacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wilson 95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clopper-Pearson 95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p by chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probability of so many right answers, or more, by guessing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information transfer as counted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much it is too high on average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response time of right answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>df</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eps GG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p GG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eps HF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p HF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>partial eta²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gen. eta²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A comparison of the conditions for this pattern alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greenhouse and Geisser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Huynh and Feldt, at most 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Generalised eta squared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants that are complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The information transfer of few trials is too high: with %1 trials, somebody who only guesses shows %2 bit on average. Read the corrected value beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With fewer than 5 k² trials even the corrected value is rough.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is one condition only, so the patterns are compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within participants, condition × pattern, of the shares of right answers; below, the conditions compared for each pattern.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunText</name>
    <message>
        <source>STOP ended the measurement.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release STOP and measure again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet was lost during the measurement.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connect it and measure again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The computer was too slow for the measurement: the bracelet stood still meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measure again with less other work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something else was played meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measure again</source>
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
        <source>a property of the camera is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a property of the soft tube is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a finger&apos;s size or motion is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number of the probing is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the arm under the soft tube does is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a property of the servoing arm, its sensor, object or task is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a camera has no effect &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>effect &quot;%1&quot; needs a camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>effect &quot;%1&quot; needs a servoing arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene is not that of a tactile array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene is not that of an arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene is not that of a camera in a soft tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene is not that of a servoing arm</source>
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
    <message>
        <source>the camera is too far from the tube&apos;s axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dots touch each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than the pitch of %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there would be too few or too many dots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 m and less than the radius of %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is deeper than the skin gives way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no tray to keep level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an [object.hinge]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SceneRecording</name>
    <message>
        <source>another program reads the recording, which keeps this name</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SceneRun</name>
    <message>
        <source>the folder cannot be made or written to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the image cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the protocol has a stimulus that does not come with the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tasks, letters and conditions whose patterns come with the program</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ServoCurves</name>
    <message>
        <source>this is no number of a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from -1e12 to 1e12, or NA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the time falls, or there is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>times in order</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ServoFigure</name>
    <message>
        <source>Force, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoP y, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoC x, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DZMP y, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α z, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Way, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tactile servoing: force and features over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>desired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>true</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tactile servoing, simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tactile servoing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time, s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ServoTexts</name>
    <message>
        <source>Free motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co-manipulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>searching for the contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturated taxel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance from the measured pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end of a joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>singular arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gap between frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unusable numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the limits that act</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated cycle: %1 µs, %2 times real time. Contact %3 %, kinematics %4 %, features %5 %, control %6 %, dynamics %7 %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <comment>a source, and which of its runs</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, partly without DZMP</source>
        <comment>a run</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, without DZMP</source>
        <comment>a run</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoP x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoP y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ℭZMP x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoC y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ℭZMP y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CoC x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α z</source>
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
        <source>Seed of all random numbers of the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated time in seconds; otherwise what the scene says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene file, or the name of a scene that comes with the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List the scenes that come with the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for summary.json, the recording and its data as CSV; with --ablate the CSV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formats of the chart of a servo run in --out, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folders of earlier servo runs for the same chart, up to five</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave out one effect at a time and tell how far the measures move against their spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of each variant, with seeds from --seed upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is required</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is for scenes of a servo</source>
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
    <name>SimulatedCameraDevice</name>
    <message>
        <source>The camera was unplugged.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SimulatedTube</name>
    <message>
        <source>the lens of the camera folds: no camera has it</source>
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
    <name>StimulusText</name>
    <message>
        <source>STOP was pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bracelet was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bracelet stood still for too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pattern could not be played: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something else stopped the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StoreText</name>
    <message>
        <source>%1, process %2</source>
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
    <name>StudyChecks</name>
    <message>
        <source>Protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend the protocol at this place and open it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no protocol is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a protocol, or begin with the paper&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the protocol has no trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give practice or test at least one repetition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no participant is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a participant, or add a new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in a session already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in a session already, at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish or abort the other session, or choose another participant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has finished this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the next session or another participant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no bracelet is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug the bracelet in and choose it in the menu Bracelet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check cable and power supply; it goes on by itself when it is back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP is engaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release STOP when it is safe.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is simulated: nobody can feel it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a real bracelet, or a pilot or simulated study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect the drive of the study, or choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow writing to the folder, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disk space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 MB are free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free space until there are %1 MB, or choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data store</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the server or mend the network; then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a copy of the study&apos;s folder and open the study again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not needed: simulated participants hear nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the protocol has none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the noise is not confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the noise, measure its level at the ear, and confirm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the noise, measure %1 dBA at the participant&apos;s ear, and confirm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>confirmed</source>
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
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD or ~/.pgpass. The folder gets the exports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formats of the figures, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for report.html, confusion_long.csv, summary.csv, group.csv, anova.csv, figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write pink noise that can be played in a loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sound file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square against full scale, dB; how loud it is at the ear has to be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to analyze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>folders of studies, trial CSVs, or a server (--store)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dBFS</source>
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
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
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
    <message>
        <source>Subject response, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subject response, trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subject response, % and trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PILOT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
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
    <name>StudyNoise</name>
    <message>
        <source>these settings of the noise are out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an even number of samples up to %1, and frequencies above 0 up to half the rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no frequency in this band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more samples or a wider band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the noise would be clipped at this level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a level of %1 dBFS at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sound is too long for a WAV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
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
    <name>StudyQuestionnaire</name>
    <message>
        <source>&quot;%1&quot; is not answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the answer to &quot;%1&quot; is too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 characters at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be answered by &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from 1 to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of the choices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the answers are not those of this questionnaire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one answer an item, in their order</source>
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
    <name>StudyReport</name>
    <message>
        <source>There are no test trials.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct answers of the group; the interval is that of Student&apos;s t over participants (95 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SD, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots: participants. Marks: mean with the t interval over participants.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows: presented; columns: answered. Percent of the row, all participants.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presented</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: trials and share of the row in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confusion matrices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>df</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of the participants&apos; correct answers for each pattern; two conditions are compared within participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns and conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of the participants with the t interval (95 %).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants&apos; median response times of correct, answered test trials, from the onset of the stimulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median of the medians, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots: medians of participants. Marks: the median of these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information transfer of the pooled answers in bit, its bias, and the bootstrap interval over participants (95 %, of the measured value)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A guesser would show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>few trials: fewer than 5 k²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information transfer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filled: measured, with the bootstrap interval. Hollow: less the bias.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measured value is too high with few trials: even a participant who only guesses shows more than 0 bit. Compare it with the column of the guesser, and use the corrected value with care.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each participant, test trials; intervals of 95 %, p of so many correct answers by chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wilson, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clopper-Pearson, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p of chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transfer, bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guesser, bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrected, bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median time, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis of variance within participants of the shares of correct answers; p with the corrections of Greenhouse and Geisser and of Huynh and Feldt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>partial η²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>generalised η²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is left out: a cell is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PILOT: these data were taken to try the study out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED: these answers were made by a program, not by people.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot make the folder</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyScene</name>
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
    <name>StudyScenes</name>
    <message>
        <source>%1, %2</source>
        <comment>task, condition</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pattern(s); %2</source>
        <comment>task; conditions</comment>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Repetitions of each pattern: %1 in practice, %2 in the test; %3 test trials a participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stimulus %1 s, answer within %2 s %3</source>
        <comment>numbers; of what</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of its onset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pink noise, %1 dBA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>trials kept</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>participant, session</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session %1 of %2, row %3 of the Williams square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This session was interrupted after %1 of %2 trials. What was answered is kept; it goes on with the same order.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session can begin when all checks have passed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin the rehearsal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with the rehearsal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated participants go through all sessions, with the same code as people.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Halt the rehearsal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the next session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This session is finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sessions of all participants are finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enrol the first participant at the left: the order of the conditions follows from the order of enrolment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This participant has finished all sessions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is asked again when a session of this participant begins or is gone on with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is asked again only when this session is interrupted and gone on with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session is finished without it, and then it is not asked again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated participant fills in “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noting that “%1” is left out …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeping the answers …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant fills in “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again to leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” could not be left out, because the note about it could not be kept. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again to keep the answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The answers to “%1” could not be kept; they are still in the participant&apos;s window. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the questionnaire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin the test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice is over. In the test there is no feedback unless the protocol says so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on after STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOPPED. The bracelet is off. A trial that ran will be shown again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stimulus was interrupted: %1. The trial will be shown again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the STOP button for a second to release it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again to keep the last trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last trial could not be kept; it is still in memory. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session was aborted. What was answered is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This session is finished. Thank the participant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeping the trial …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready for the next trial.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stimulus begins …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stimulus is felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The right answer is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated participant is at work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant goes on with Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A pause follows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your answers could not be kept yet. Please tell the experimenter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No session is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudySchema</name>
    <message>
        <source>a newer program made this study (schema %1, this one knows %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write the study: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read the study: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program made this database (schema %1)</source>
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
    <message>
        <source>a folder of its own for each study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this folder has a study that is kept in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this folder is that of another study, on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this does not say which study the folder is for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>server, created_utc and seed of a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no address of a PostgreSQL server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the address has the port &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from 1 to 65535</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the option &quot;%1&quot; of the address has a semicolon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value without semicolons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the address has the unknown option &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a study on a server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>small letters, digits and _, not a digit first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Qt&apos;s driver for PostgreSQL is not installed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the package %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the server has no study &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of a study that was begun there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another station went on with this participant while the server was away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one session of a participant at a time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the study is damaged: a session or a trial has a number that its protocol does not have</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a study of this name already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a new name, or to go on with the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another name: files have %1 for no value or for all participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other stations enrol participants all the time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in a session already, at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these trials belong to another study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trial is safe in %1 and is sent when the server is back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this questionnaire belongs to another place in the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this questionnaire was answered already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each questionnaire once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write the file: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a trial that was kept here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot remove the file: %1</source>
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
    <name>StudyWatermark</name>
    <message>
        <source>PILOT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
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
    <message>
        <source>Δ %1 %, rms %2 %</source>
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
    <name>TrackCommand</name>
    <message>
        <source>%1 of %2 frames could not be used. The last reason: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames that are missing by their time stamps: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contacts on the soft tube in a video or before a camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Video, pattern of numbered images (frame_%04d.png) or number of a camera; nothing touches the tube in the first frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera file, as calibrate writes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How contacts are found: exact ones take longer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the output would replace the input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the camera gives no frames any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the video has no frame that can be decoded</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TradeoffCommand</name>
    <message>
        <source>there is no ladder &quot;%1&quot; (expected %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure on this machine what accuracy costs in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ladders of --list; otherwise all of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List the ladders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for tradeoff.csv and a picture of each ladder (SVG)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refuse the times of a rung when the machine ran more unevenly than this meanwhile, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>the machine was too busy: the times of %n rung(s) were refused</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>a spread of at most %1 %; close other programs, or see --largest-spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rung</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>99 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>* no other rung is both as quick and as exact. Measured in %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>✓ right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aborted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>device fault, comes again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>practice %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test %1</source>
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
    <name>VisionText</name>
    <message>
        <source>The frame could not be decoded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image is too small to show printed dots: %1 x %2 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least %1 pixels on each side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image shows no printed dots on the skin (%1 found).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a frame in focus, in which nothing touches the skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The printed dots are too faint to be followed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame does not show the skin: %1 of %2 dots found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera sees none of the skin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image is too small for optical flow: %1 x %2 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image shows no pattern on the skin whose movement could be seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no frame of the untouched skin to compare with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame has %1 x %2 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 x %2 pixels, as in the camera&apos;s calibration</source>
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
    <name>teleta::calibrate::FeltPanel</name>
    <message>
        <source>The motors were balanced by feel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1 starts at %2 % of the full drive (95 %: %3 to %4 %).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of motor %1, beside motor 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 answers so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The answers do not fit together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the next burst.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did you feel it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Was the second burst stronger?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bracelet cannot play now: it is not connected, STOP is engaged, or a study uses it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now and then nothing is played. Answer yes only when you are sure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guess when you are not sure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questions about what is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the burst be felt, as often as you like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes (Y)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No (N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last answer (Backspace)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the motors as they were</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorChart</name>
    <message>
        <source>Speed of motor %1 over its drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording of motor %1, and the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive (%)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed (Hz)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: curve and lag are assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the variance, residual %2 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording of this motor yet: measure it, or open a recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured (simulated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorTable</name>
    <message>
        <source>assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by feel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start %1, lag and curve %2</source>
        <comment>where the values come from</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors of the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start (%)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full (%)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rise (ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall (ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed (Hz)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive at which the motor begins to turn, with its standard error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive of intensity 1, so that all motors are equally strong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From rest to 90 % of a speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a speed to 10 % of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed at the full drive of this motor</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorsView</name>
    <message>
        <source>answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It turns at %1 Hz now, says the bracelet&apos;s sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All motors are assumed again. Undo brings back what was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>balance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every measured motor now ends at the speed of the slowest one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring motor %1: stairs up to the full drive, then pulses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1 was not calibrated. %2</source>
        <comment>a motor, and why not</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: starts at %2 to %3 % of the drive, rises in %4 ± %5 ms, falls in %6 ± %7 ms, reaches %8 Hz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a bracelet in the menu Bracelet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not calibrated: motors are assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibrated, saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibrated, not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a study uses the bracelet: its motors stay as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive the motor up and down and record it with the bracelet&apos;s sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This bracelet has no sensor: open a recording, or answer by feel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last change, or the last answer (Ctrl+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read a profile of this bracelet from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a &amp;copy…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the profile to another file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget what was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the profile for this bracelet: it is used whenever it is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure this motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure &amp;all six</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One after another, with the bracelet&apos;s sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV with time_s,commanded and speed_hz of a tachometer or signal of an accelerometer or microphone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the &amp;excitation…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the motor is told during a measurement, as CSV: for a sensor of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find its start by &amp;feel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bursts that get weaker and stronger; you say what you felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Balance by feel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the strength of each motor with that of motor 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balance by the cur&amp;ves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let all measured motors end at the speed of the slowest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration of the bracelet&apos;s motors</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraPanel</name>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for a picture of the tube with nothing touching it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No reference yet: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This finder cannot be used: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The finder %1 is being made ready.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm has drawn back from contact %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm draws back from contact %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm follows contact %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is held. Tick the box to let it react again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Finder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How contacts are found: the printed dots alone, or dense flow by one of OpenCV&apos;s presets; the number divides the image&apos;s size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Displacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show how far the pattern on the skin has moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New &amp;reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the next picture as that of the untouched tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this picture; contacts are followed on (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm may r&amp;eact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off: the arm stands, whatever touches it. STOP takes this away until you give it again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraView</name>
    <message>
        <source>camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;What the camera sees inside the tube. Lines show, enlarged, how far the printed pattern has moved since nothing touched the tube; outlines are contacts, each in the colour of its number.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, dragging moves, a double click shows all.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventModel</name>
    <message>
        <source>touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arm follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>begins anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventTable</name>
    <message>
        <source>camera-events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened to the tube, the newest first. The context menu copies and saves the list.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::camera::PairModel</name>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excluded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixel, px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image, px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::camera::ResidualView</name>
    <message>
        <source>Residuals on the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residuals on the unrolled cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its pixel, with an enlarged arrow to where the camera projects its point. Arrows without a pattern are noise; arrows that flow are something that the camera does not describe.&lt;/p&gt;&lt;p&gt;A pixel outside the dashed circle has no ray.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its point on the cylinder, cut open at the back, with an enlarged arrow to where its pixel is located. The colour is the error along the axis.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out as wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excluded by you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off by %1 in the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off by %1 on the cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residuals-image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residuals-cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Exclude pair %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use pair %1 again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::camera::StageBar</name>
    <message>
        <source>prepare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>displacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>segment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms a frame, %2 frames/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n passed over</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 ms</source>
        <comment>stage of a computation and its time</comment>
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
        <source>at %1 s   arm time %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Torque of each joint over time. The coloured band is the torque window: between its ends a touch is evaluated. Grey stretches are touches with their numbers, from the first torque above the noise to the estimate.&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its ends.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointPlot</name>
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
        <source>charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Strips</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::charts::TimeChartView</name>
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
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show %1 s (Ctrl+wheel for other spans)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the picture; samples go on being kept (Space)</source>
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
    <name>teleta::charts::TimePlot</name>
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
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>since %1, %n times</source>
        <translation type="unfinished">
            <numerusform></numerusform>
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
    <message>
        <source>Open &amp;camera…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A camera in the soft tube, or a video of one, with its calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The source that the views show</source>
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
    <name>teleta::console::BraceletMenu</name>
    <message>
        <source>&amp;Simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;USB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modbus: %1</source>
        <comment>a device file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Modbus…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file that describes the registers of a motor driver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a Modbus motor driver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Devices (*.toml)</source>
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
    <message>
        <source>A study uses the bracelet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motors are not calibrated (page Calibrate).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not calibrated: the motors are assumed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::CalibratePage</name>
    <message>
        <source>What can be calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracelet motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraCalibrator</name>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Load pairs...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs of pixels and points: CSV with u_px,v_px,x_m,y_m,z_m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save pai&amp;rs...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All pairs, those that are left out too, as they are loaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save camera...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera of the chosen method, for teleta locate and the camera view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Probe the simulated tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collect pairs: a simulated person presses a stick on the marked places of a simulated tube, and takes one in ten for its neighbour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Method:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method of calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear (DLT)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least squares</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Exclude wrong pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves the pairs that are marked as wrong out for every method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image, mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface, mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Exclude, or use again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Finds the camera inside the tactile cylinder from pairs: a pixel and the point of the surface that was probed there.&lt;/p&gt;&lt;p&gt;Load a CSV file or drop it here, or type pairs in. Wrong pairs are found and left out; you may exclude more or remove them (Delete in the table), and take every step back.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs (*.csv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>added pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>removal of %n pair(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>use of %n pair(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exclusion of %n pair(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>image and cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first touch is awaited.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load pairs of pixels and probed points, drop their file here, type them in below, or let a simulated tube be probed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrating...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No calibration: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n pair(s) kept; </source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>their points are located to within %1 on average, and the camera is sure to within %2. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This method knows no lens: use it to compare only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Be careful: residuals of neighbours are alike, so the pairs hold something that this camera does not describe (a shell that has moved, a wrong radius).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The residuals have no pattern. Good.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a pattern</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraDialog</name>
    <message>
        <source>Start &amp;again at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of a connected camera (0 is /dev/video0), or a video file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera file that the page Calibrate or teleta calibrate has written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Camera or video:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a video</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Video of a camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Videos and pictures (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ca&amp;libration:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a camera file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera files (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::CostMeasuring</name>
    <message>
        <source>The costs that were measured before cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ladders could not be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measured costs cannot be kept.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::CostPage</name>
    <message>
        <source>%1 (not measured)</source>
        <comment>name of a ladder</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (frontier)</source>
        <comment>name of a rung</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused: too noisy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the ladder %1 first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 on average, 99 of 100 frames within %3 (1640 x 1232 pixels).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rung is so quick: of 100 frames one may take longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rung %1 cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ladders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ladders of rungs from cheap to exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure this ladder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure &amp;all ladders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes some minutes; the console can be used meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured on this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs and sources first: what they compute makes times uncertain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure this ladder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure all ladders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rung</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>99 % time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rungs with their errors and times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rung in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rung that finds the contacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of a frame, now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time &amp;budget of a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ms a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use the best rung within it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No camera is shown on the page Operate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a demo with a camera</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::ExportDialog</name>
    <message>
        <source>Export pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>commanded intensities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the motors are predicted to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Values:</source>
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
    <message>
        <source>%1: %2 is missing</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch %1: %2. Its pattern %3 is missing: nothing was played. Choose another one, or put it back among your patterns.</source>
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
        <source>Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the bracelet can say: edit, check and play patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>User studies: from the first practice trial to confusion matrices and ANOVA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What has to be measured: the motors of the bracelet, the camera in the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What accuracy costs in time on this machine, and the rung that the camera uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page Patterns opens the edits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>my own</source>
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
</context>
<context>
    <name>teleta::console::MotorCalibrator</name>
    <message>
        <source>The profile of the motors cannot be used; they are assumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the recording of a motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the excitation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy of the profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is of another bracelet.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is of “%1”, this one is “%2”. Measure this one, or connect the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::NewStudyDialog</name>
    <message>
        <source>&amp;Participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In a file of this folder: one station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On a PostgreSQL server: stations share it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run: real participants, counts as data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pilot: people try it, marked PILOT everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: no people, marked SIMULATED everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The orders of all trials follow from it: the same seed gives the same study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Folder, which is made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder, with its whole path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 to 18446744073709551615.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::NoisePlayer</name>
    <message>
        <source>this computer has no sound output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot play 48 kHz</source>
        <comment>a sound output</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>headphones that are plugged in, or the noise from another device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sound output stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>headphones that stay plugged in</source>
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
    <message>
        <source>Servo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events</source>
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
    <name>teleta::console::PairEntry</name>
    <message>
        <source>Pi&amp;xel, px:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Point, mm:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u, to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v, down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z of the point, along the tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this pair up (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternCollection</name>
    <message>
        <source>The pattern could not be saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern could not be duplicated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be renamed.</source>
        <comment>a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be deleted.</source>
        <comment>a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was renamed.</source>
        <comment>a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <comment>a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be brought back.</source>
        <comment>a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternsPage</name>
    <message>
        <source>The edits that are not saved could not be kept aside: a crash would lose them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was exported.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be exported.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has edits that are not saved.</source>
        <comment>a pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program ended without saving %1, edited %2. The file on disk is as it was.</source>
        <comment>a pattern, a time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>There are %n more.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Open the Edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard Them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All patterns (*.json *.hjif *.haptic *.haptic.zip *.tact)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HJIF (*.hjif)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Haptic clips (*.haptic *.haptic.zip)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tact (*.tact)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::ProbingStrip</name>
    <message>
        <source>How far the probing is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED: a person probes the tube; pairs until now: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sto&amp;p probing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what was collected until now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::ProtocolDialog</name>
    <message>
        <source>Protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the onset of the stimulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ×</source>
        <comment>after a number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all repetitions together, in random order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each repetition in a random order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;escription</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stimulus, at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer &amp;within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May be felt a&amp;gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or&amp;der</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Masking noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questionnaires</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n questionnaire(s), kept as they are</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Add a task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pape&amp;r&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a st&amp;udy…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feedback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pictures in view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> × each pattern</source>
        <comment>after a number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for example shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for example static, dynamic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>letter and name, one a line, for example A circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this form</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n test trial(s) a participant</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source> (expected: %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Saved: %1</source>
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
    <name>teleta::console::ServerFields</name>
    <message>
        <source>otherwise PGPASSWORD or ~/.pgpass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Used for this connection, and kept nowhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass&amp;word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The address of a server looks like %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::ServerStudyDialog</name>
    <message>
        <source>Open a study on a server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exports go here, and trials while the server is away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Folder on this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder, with its whole path.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyController</name>
    <message>
        <source>a session of the open study is going on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the open study is being read or written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to leave the session first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to try again in a moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a folder</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study could not be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rehearsal could not be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be enrolled.</source>
        <comment>a participant</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study could not be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session could not begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved, read back and compared: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trials are safe in the study, but could not be exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session could not be closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The note could not be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The note is safe in the study, but could not be exported.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyPage</name>
    <message>
        <source>Results of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the user study of the paper, or one of your own: from the first practice trial to confusion matrices and ANOVA.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch a rehearsal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated participants go through the whole study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study of the paper&apos;s protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder of a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study on a server…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study that several stations share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant&apos;s screen was lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant&apos;s window is beside the console now, and the session pauses. Plug the screen in and show the window again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise cannot be played.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play it from another device, and confirm its level.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figure could not be saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A session of this study was interrupted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that was answered is lost. Go on with it, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper&apos;s protocol could not be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ Not played: %1. Play it from another device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no completed trials yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test trials that are complete; others are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The results could not be computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The export failed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the matrix shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spee&amp;d</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real time, felt on the bracelet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times real time, not played</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast simulated participants are; it can be changed between sessions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyRunner</name>
    <message>
        <source>there is no pattern &quot;%1&quot; to be felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tasks, letters and conditions whose patterns come with the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::console::TubeFields</name>
    <message>
        <source>&amp;Image:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Radius:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Len&amp;gth:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the image in which the pixels are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the image in which the pixels are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the tactile cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tactile cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the surface on which the points are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the surface, from z = 0 of the sensor&apos;s frame</source>
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
    <name>teleta::costs::CostChart</name>
    <message>
        <source>median time of one call</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean error over time of the ladder %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <comment>name of a rung</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::editor::LawList</name>
    <message>
        <source>Laws of the display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laws: looking…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laws: no warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laws: %1 to look at</source>
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
    <name>teleta::editor::PatternEditor</name>
    <message>
        <source>&amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared with %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared with %1: largest difference %2 % (motor %3 at %4 s), rms %5 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared with %1: the motors do the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Editor of patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New, open, recent, save, export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An empty pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a pattern file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the pattern; one without a file goes to one&apos;s own patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the pattern under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write HJIF, .haptic, AHAP, .tact, CSV or WAV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play from the playhead, or pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin again at the end; Shift and a drag on the ruler set the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every click adds a breakpoint (P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times on a grid; Alt while dragging leaves it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step of the grid, and of the arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step of the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an object at the playhead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>↺ 60°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the next one did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>↻ 60°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the one before did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The order of the motors the other way round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern for the other arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole pattern (Ctrl+0 on the timeline)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare no more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>built-in, edits make a copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not saved</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::editor::PatternInspector</name>
    <message>
        <source>Numbers from 1 to 6, separated by spaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burst:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Onset to onset:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Onset by the law of apparent motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First motor:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counter-clockwise (rising numbers)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burst by the law of apparent motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second motor:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Period:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begins at:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its time:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its angle:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the arm:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intensity:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Called:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake into breakpoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Le&amp;ngth:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Loop:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin of the loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of the loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is played again and again; the whole pattern when both are the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;ells:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no condition</source>
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
        <source>&amp;Tags:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N&amp;otes:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Breakpoint of motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 breakpoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale by:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stretch to:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::editor::PatternLibrary</name>
    <message>
        <source>Filter: name, tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter the patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo what was done to the library last (Ctrl+Z in the list)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Double-click or &lt;b&gt;Enter&lt;/b&gt; opens a pattern. Built-in patterns stay as they are: the first edit makes a copy. In one&apos;s own: &lt;b&gt;F2&lt;/b&gt; renames, &lt;b&gt;Ctrl+D&lt;/b&gt; duplicates, &lt;b&gt;Delete&lt;/b&gt; deletes, &lt;b&gt;Ctrl+Z&lt;/b&gt; takes that back.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built-in: shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built-in: stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none yet: edit a built-in one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tags: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare with It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::editor::StrokePad</name>
    <message>
        <source>Unrolled forearm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a stroke: it is felt as a point that moves along it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;The forearm, unrolled: from left to right once around it. What is drawn here with the mouse becomes a stroke of the pattern, from the playhead on, as fast as it was drawn. &lt;b&gt;Esc&lt;/b&gt; gives it up.&lt;/p&gt;&lt;p&gt;By keys: the arrows move a cursor, &lt;b&gt;Space&lt;/b&gt; sets a point a quarter of a second after the last one, &lt;b&gt;Backspace&lt;/b&gt; takes it back, &lt;b&gt;Enter&lt;/b&gt; finishes.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a stroke here</source>
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
    <message>
        <source>&lt;p&gt;Six motors over time. The blue line is what is asked of a motor, the thin one what the motor is predicted to do; it is hatched where the motor cannot follow.&lt;/p&gt;&lt;p&gt;Double-click or &lt;b&gt;P&lt;/b&gt;: add breakpoints. Drag: move, with &lt;b&gt;Alt&lt;/b&gt; off the grid. Drag on the ground, or with &lt;b&gt;Shift&lt;/b&gt;: select. Double-click on a breakpoint or &lt;b&gt;Enter&lt;/b&gt;: type its numbers. Arrow keys: move what is selected, with &lt;b&gt;Shift&lt;/b&gt; farther in time and finer in intensity. &lt;b&gt;Page Up&lt;/b&gt;, &lt;b&gt;Page Down&lt;/b&gt;: lane; &lt;b&gt;,&lt;/b&gt; and &lt;b&gt;.&lt;/b&gt;: breakpoint, with &lt;b&gt;Shift&lt;/b&gt; one more; &lt;b&gt;N&lt;/b&gt;: object; &lt;b&gt;Insert&lt;/b&gt;: a breakpoint at the playhead; &lt;b&gt;[&lt;/b&gt; and &lt;b&gt;]&lt;/b&gt;: begin and end of the loop, &lt;b&gt;\&lt;/b&gt;: none.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; and wheel: zoom. &lt;b&gt;Shift&lt;/b&gt; and wheel: scroll. On the ruler a drag moves the playhead and, with &lt;b&gt;Shift&lt;/b&gt;, sets the loop.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::servo::ForceStrip</name>
    <message>
        <source>Force over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force that the array reads (line) and that is wanted (dashes), over the last 20 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>actual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>desired</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoPanel</name>
    <message>
        <source>No servo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP: the arm is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No limit acts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits that act: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and name of a task</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The running task; choose one to begin it now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force with which the array presses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sliding speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the edge, while it is explored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All gains of the regulators, in percent of the scene&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balance the &amp;moment (DZMP)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off: the controller without the distance to the zero-moment point</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoPicture</name>
    <message>
        <source>Features and matrices of the servo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Desired and actual features as the inverse tactile Jacobian selects them; bold rows act on the motion through the projection matrix P.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Desired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>J⁻¹, features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P, motions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoRunsView</name>
    <message>
        <source>&amp;Add Recorded Run…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run that teleta simulate --out has written: its servo.csv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget Other Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps only the run that goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies or saves the chart or its data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Servo runs in one chart: the running one, those before its source was restarted or another source was shown, and recorded ones.&lt;/p&gt;&lt;p&gt;To see what the moment is for, restart the scene with and without “Balance the moment”.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Recorded Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo runs (servo.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>servo-runs</source>
        <comment>name of a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No run yet. Runs of servos are drawn here, one over the other.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::AnswerButton</name>
    <message>
        <source>Answer %1: %2</source>
        <comment>letter, name</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. This was felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. This was answered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ your answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>your answer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::ConfusionView</name>
    <message>
        <source>Confusion matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Rows: what was presented. Columns: what was answered, and NONE for no answer in time. &lt;b&gt;Space&lt;/b&gt; or a double click changes between counts and percent of the row.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>count of a row</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not answered in time: </source>
        <comment>pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 answered as %2: </source>
        <comment>pattern, pattern</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In &amp;Percent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::ParticipantPicker</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::studyview::ParticipantWindow</name>
    <message>
        <source>Please wait for the experimenter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Space for the next trial.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Space for the first trial.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which pattern do you feel? Press R to feel it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which pattern do you feel?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There was no answer in time. The marked pattern was felt. Press Space to go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right. Press Space to go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That was another one: the pattern marked with ✓ was felt. Press Space to go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause. Please wait for the experimenter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. The bracelet is off. Please wait for the experimenter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This part is finished. Thank you!</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — %2, trial %3 of %4</source>
        <comment>task, phase, numbers</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::QuestionnaireForm</name>
    <message>
        <source>This does not fit: %1.</source>
        <comment>what is expected</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Please answer this question.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hands the answers over (Ctrl+Return)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::QuestionnaireItemView</name>
    <message>
        <source>%1 (may be left out)</source>
        <comment>a question</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <comment>question, point, points</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::ResultsView</name>
    <message>
        <source>All participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody beside them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants that are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick one participant, or a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants beside them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick those whom you want to compare with: a second group side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the matrices show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All participants together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the trials, or these results, into the folder of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials as &amp;Psych-DS (CSV)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials as &amp;BIDS (TSV)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials for a &amp;spreadsheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Results: tables, figures, R script</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::SessionPanel</name>
    <message>
        <source>Stop the noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Abort the session?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session ends here. What was answered is kept, and the session can be gone on with later, where it stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Abort the session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the questionnaire out?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is filled in is lost, and a note says that it was left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do next (Ctrl+Return)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks before the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise &amp;confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The participant hears the masking noise at the level of the protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presented</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A note on this session; Return keeps it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participant&apos;s &amp;window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the participant&apos;s window, on the second screen where there is one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Leave the questionnaire out…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes on without the participant&apos;s answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pauses after the present trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Abort…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>teleta::studyview::StudyPanel</name>
    <message>
        <source>● On the server: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ Server away: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ The study cannot be used: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 trials</source>
        <comment>kept</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin a new study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The &amp;folder of a study…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study on a &amp;server…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pro&amp;tocol…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the protocol, or make another one from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Participants and their sessions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a new participant, for example P07</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a new participant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enrol this participant</source>
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
    <message>
        <source>The joint readings are old: nothing is moved until they come again.</source>
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
