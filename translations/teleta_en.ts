<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AlsaText</name>
    <message numerus="yes">
        <source>The sound card has %n output(s).</source>
        <translation>
            <numerusform>The sound card has %n output.</numerusform>
            <numerusform>The sound card has %n outputs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ArmCommand</name>
    <message numerus="yes">
        <source>%1: %n joint(s) from %2 to %3</source>
        <translation>
            <numerusform>%1: %n joint from %2 to %3</numerusform>
            <numerusform>%1: %n joints from %2 to %3</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BraceletContent</name>
    <message numerus="yes">
        <source>by the JND at %n reference(s)</source>
        <translation>
            <numerusform>by the JND at %n reference</numerusform>
            <numerusform>by the JND at %n references</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CertificateText</name>
    <message numerus="yes">
        <source>%1, %n core(s)</source>
        <translation>
            <numerusform>%1, %n core</numerusform>
            <numerusform>%1, %n cores</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ComparisonContent</name>
    <message numerus="yes">
        <source>no spread of the times in %n case(s): nothing left out</source>
        <translation>
            <numerusform>no spread of the times in %n case: nothing left out</numerusform>
            <numerusform>no spread of the times in %n cases: nothing left out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ContourPicture</name>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DevicesCommand</name>
    <message numerus="yes">
        <source>it sends frames of %n chip(s)</source>
        <translation>
            <numerusform>it sends frames of %n chip</numerusform>
            <numerusform>it sends frames of %n chips</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExclusionReport</name>
    <message numerus="yes">
        <source>no spread of the times, so nothing was left out, in %n case(s)</source>
        <translation>
            <numerusform>no spread of the times, so nothing was left out, in %n case</numerusform>
            <numerusform>no spread of the times, so nothing was left out, in %n cases</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportCommand</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n row</numerusform>
            <numerusform>%n rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>%n damaged block left out</numerusform>
            <numerusform>%n damaged blocks left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n message</numerusform>
            <numerusform>%n messages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>GaugeTexts</name>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ImportCommand</name>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n message</numerusform>
            <numerusform>%n messages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged or of another shape</source>
        <translation>
            <numerusform>%n damaged or of another shape</numerusform>
            <numerusform>%n damaged or of another shape</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out</source>
        <translation>
            <numerusform>%n damaged chunk left out</numerusform>
            <numerusform>%n damaged chunks left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged record(s) left out</source>
        <translation>
            <numerusform>%n damaged record left out</numerusform>
            <numerusform>%n damaged records left out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>JackText</name>
    <message numerus="yes">
        <source>&quot;%1&quot; has %n output(s).</source>
        <translation>
            <numerusform>&quot;%1&quot; has %n output.</numerusform>
            <numerusform>&quot;%1&quot; has %n outputs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ParticipantReport</name>
    <message numerus="yes">
        <source>In %n trial(s) the time was over before you answered.</source>
        <translation>
            <numerusform>In %n trial the time was over before you answered.</numerusform>
            <numerusform>In %n trials the time was over before you answered.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlaneFit</name>
    <message numerus="yes">
        <source>%n point(s) are too few</source>
        <translation>
            <numerusform>%n point is too few</numerusform>
            <numerusform>%n points are too few</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProtocolSummary</name>
    <message numerus="yes">
        <source>%n for each participant, at most.</source>
        <translation>
            <numerusform>%n for each participant, at most.</numerusform>
            <numerusform>%n for each participant, at most.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s).</source>
        <translation>
            <numerusform>%n question.</numerusform>
            <numerusform>%n questions.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It may be felt again %n time(s).</source>
        <translation>
            <numerusform>It may be felt again %n time.</numerusform>
            <numerusform>It may be felt again %n times.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each stimulus %n time(s).</source>
        <translation>
            <numerusform>Each stimulus %n time.</numerusform>
            <numerusform>Each stimulus %n times.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After every %n trial(s), at least %1.</source>
        <translation>
            <numerusform>After every trial, at least %1.</numerusform>
            <numerusform>After every %n trials, at least %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n, interleaved.</source>
        <translation>
            <numerusform>%n.</numerusform>
            <numerusform>%n, interleaved.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReplayCommand</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>%n damaged block left out</numerusform>
            <numerusform>%n damaged blocks left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost at this speed</source>
        <translation>
            <numerusform>%n frame lost at this speed</numerusform>
            <numerusform>%n frames lost at this speed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were not printed</source>
        <translation>
            <numerusform>%n frame was not printed</numerusform>
            <numerusform>%n frames were not printed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReportText</name>
    <message numerus="yes">
        <source>Stimuli: %n trial(s) were played on a bracelet; the longest write of a frame took %1 ms.</source>
        <translation>
            <numerusform>Stimuli: %n trial was played on a bracelet; the longest write of a frame took %1 ms.</numerusform>
            <numerusform>Stimuli: %n trials were played on a bracelet; the longest write of a frame took %1 ms.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stimuli: the frames of %n trial(s) were counted.</source>
        <translation>
            <numerusform>Stimuli: the frames of %n trial were counted.</numerusform>
            <numerusform>Stimuli: the frames of %n trials were counted.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RosArmCheckReport</name>
    <message numerus="yes">
        <source>the arm cannot be moved: %n problem(s)</source>
        <translation>
            <numerusform>the arm cannot be moved: %n problem</numerusform>
            <numerusform>the arm cannot be moved: %n problems</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SiteProgramText</name>
    <message numerus="yes">
        <source>All %n device(s) are ready.</source>
        <translation>
            <numerusform>The %n device is ready.</numerusform>
            <numerusform>All %n devices are ready.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StimulusText</name>
    <message numerus="yes">
        <source>%n object(s) of the stimulus have %1</source>
        <translation>
            <numerusform>%n object of the stimulus has %1</numerusform>
            <numerusform>%n objects of the stimulus have %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyPeople</name>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n session</numerusform>
            <numerusform>%n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n trial</numerusform>
            <numerusform>%n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>number %1 of the enrolment, on %2, %n trial(s)</source>
        <translation>
            <numerusform>number %1 of the enrolment, on %2, %n trial</numerusform>
            <numerusform>number %1 of the enrolment, on %2, %n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n file</numerusform>
            <numerusform>%n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyScenes</name>
    <message numerus="yes">
        <source>%1: %n pattern(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1: %n pattern; %2</numerusform>
            <numerusform>%1: %n patterns; %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n track(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1: %n track; %2</numerusform>
            <numerusform>%1: %n tracks; %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %n trigger(s) could not be written: %2</source>
        <comment>device; why</comment>
        <translation>
            <numerusform>%1. %n trigger could not be written: %2</numerusform>
            <numerusform>%1. %n triggers could not be written: %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TaxelsText</name>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are not in the frame</source>
        <translation>
            <numerusform>%n byte from %1 on is not in the frame</numerusform>
            <numerusform>%n bytes from %1 on are not in the frame</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a place in a frame of %n byte(s)</source>
        <translation>
            <numerusform>a place in a frame of %n byte</numerusform>
            <numerusform>a place in a frame of %n bytes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are in no frame</source>
        <translation>
            <numerusform>%n byte from %1 on is in no frame</numerusform>
            <numerusform>%n bytes from %1 on are in no frame</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TradeoffCommand</name>
    <message numerus="yes">
        <source>the machine was too busy: the times of %n rung(s) were refused</source>
        <translation>
            <numerusform>the machine was too busy: the times of %n rung were refused</numerusform>
            <numerusform>the machine was too busy: the times of %n rungs were refused</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::GainsView</name>
    <message numerus="yes">
        <source>%n dead</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n dead</numerusform>
            <numerusform>%n dead</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too weak</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n too weak</numerusform>
            <numerusform>%n too weak</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too strong</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n too strong</numerusform>
            <numerusform>%n too strong</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stuck</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n stuck</numerusform>
            <numerusform>%n stuck</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n press(es) so far.</source>
        <translation>
            <numerusform>%n press so far.</numerusform>
            <numerusform>%n presses so far.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorsView</name>
    <message numerus="yes">
        <source>%n of %1 motors calibrated, saved</source>
        <translation>
            <numerusform>%n of %1 motors calibrated, saved</numerusform>
            <numerusform>%n of %1 motors calibrated, saved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 motors calibrated, not saved</source>
        <translation>
            <numerusform>%n of %1 motors calibrated, not saved</numerusform>
            <numerusform>%n of %1 motors calibrated, not saved</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelPanel</name>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n skipped</numerusform>
            <numerusform>%n skipped</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>%n unusable</numerusform>
            <numerusform>%n unusable</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Taking the gel at rest: nothing may touch it (%n more picture(s)).</source>
        <translation>
            <numerusform>Taking the gel at rest: nothing may touch it (%n more picture).</numerusform>
            <numerusform>Taking the gel at rest: nothing may touch it (%n more pictures).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::camera::StageBar</name>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>%n unusable</numerusform>
            <numerusform>%n unusable</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n skipped</numerusform>
            <numerusform>%n skipped</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageBar</name>
    <message numerus="yes">
        <source>%n older message(s)</source>
        <translation>
            <numerusform>%n older message</numerusform>
            <numerusform>%n older messages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>since %1, %n times</source>
        <translation>
            <numerusform>since %1, %n time</numerusform>
            <numerusform>since %1, %n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::chrome::RecordingIndicator</name>
    <message numerus="yes">
        <source>Recording %1 · %2 · %n lost</source>
        <comment>time, size of the file, frames</comment>
        <translation>
            <numerusform>Recording %1 · %2 · %n lost</numerusform>
            <numerusform>Recording %1 · %2 · %n lost</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraCalibrator</name>
    <message numerus="yes">
        <source>use of %n pair(s)</source>
        <translation>
            <numerusform>use of %n pair</numerusform>
            <numerusform>use of %n pairs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exclusion of %n pair(s)</source>
        <translation>
            <numerusform>exclusion of %n pair</numerusform>
            <numerusform>exclusion of %n pairs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>removal of %n pair(s)</source>
        <translation>
            <numerusform>removal of %n pair</numerusform>
            <numerusform>removal of %n pairs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n pair(s) kept; </source>
        <translation>
            <numerusform>%1 of %n pair kept; </numerusform>
            <numerusform>%1 of %n pairs kept; </numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::FramePreview</name>
    <message numerus="yes">
        <source>%n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <extracomment>Numbers of rows and columns, lowest and highest value</extracomment>
        <translation>
            <numerusform>%n frame of %1 × %2 taxels, %3 to %4</numerusform>
            <numerusform>%n frames of %1 × %2 taxels, %3 to %4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <translation>
            <numerusform>The first frame of %1 × %2 taxels, %3 to %4</numerusform>
            <numerusform>The first %n frames of %1 × %2 taxels, %3 to %4</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveViewService</name>
    <message numerus="yes">
        <source>%n viewer(s)</source>
        <translation>
            <numerusform>%n viewer</numerusform>
            <numerusform>%n viewers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n message(s) missed</source>
        <translation>
            <numerusform>%n message missed</numerusform>
            <numerusform>%n messages missed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::NewStudyDialog</name>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>%n test trial a participant</numerusform>
            <numerusform>%n test trials a participant</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternsPage</name>
    <message numerus="yes">
        <source>There are %n more.</source>
        <translation>
            <numerusform>There is %n more.</numerusform>
            <numerusform>There are %n more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::PlotPage</name>
    <message numerus="yes">
        <source>%1 is damaged: %n part(s) could not be read and are gaps.</source>
        <translation>
            <numerusform>%1 is damaged: %n part could not be read and is a gap.</numerusform>
            <numerusform>%1 is damaged: %n parts could not be read and are gaps.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s) outside the view: Show everything (Home)</source>
        <translation>
            <numerusform>%n signal outside the view: Show everything (Home)</numerusform>
            <numerusform>%n signals outside the view: Show everything (Home)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::ProtocolDialog</name>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>%n test trial a participant</numerusform>
            <numerusform>%n test trials a participant</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingControls</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out.</source>
        <translation>
            <numerusform>%n damaged block left out.</numerusform>
            <numerusform>%n damaged blocks left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were written to %1.</source>
        <translation>
            <numerusform>%n file was written to %1.</numerusform>
            <numerusform>%n files were written to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingDialog</name>
    <message numerus="yes">
        <source>%n taxel(s), as in the file</source>
        <translation>
            <numerusform>%n taxel, as in the file</numerusform>
            <numerusform>%n taxels, as in the file</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingImport</name>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out.</source>
        <translation>
            <numerusform>%n damaged chunk left out.</numerusform>
            <numerusform>%n damaged chunks left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged message(s) left out.</source>
        <translation>
            <numerusform>%n damaged message left out.</numerusform>
            <numerusform>%n damaged messages left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::site_view::SiteBar</name>
    <message numerus="yes">
        <source>%n state(s) of the site were lost on the way</source>
        <translation>
            <numerusform>%n state of the site was lost on the way</numerusform>
            <numerusform>%n states of the site were lost on the way</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::study::ParticipantPicker</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::tactile::ChannelSettingsPanel</name>
    <message numerus="yes">
        <source>Tared, %n taxel(s) without a reading</source>
        <translation>
            <numerusform>Tared, %n taxel without a reading</numerusform>
            <numerusform>Tared, %n taxels without a reading</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::touch::RunSheet</name>
    <message numerus="yes">
        <source>%n object(s) found</source>
        <translation>
            <numerusform>%n object found</numerusform>
            <numerusform>%n objects found</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchModel</name>
    <message numerus="yes">
        <source>95 % interval in brackets; %1, %n sample(s)</source>
        <translation>
            <numerusform>95 % interval in brackets; %1, %n sample</numerusform>
            <numerusform>95 % interval in brackets; %1, %n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchTable</name>
    <message numerus="yes">
        <source>%n touch(es)</source>
        <translation>
            <numerusform>%n touch</numerusform>
            <numerusform>%n touches</numerusform>
        </translation>
    </message>
</context>
</TS>
