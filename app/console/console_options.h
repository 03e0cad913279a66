// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/sources/recording_arguments.h"
#include "devices/foxglove/live_view.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace teleta::console {

/// What the command line of teleta-console asks for.
struct ConsoleOptions {
    QStringList files; ///< recordings, scenes, arms, sites and source lists
    QStringList scenes;
    std::vector<RecordingArguments> recordings;
    QString sourceList;
    QString record;                     ///< file to record into once all that is asked for is open
    foxglove::LiveViewOptions liveView; ///< where it listens
    bool startsLiveView = false;
    std::uint64_t seed = 1;
    QString pattern;       ///< id or file to open on the Patterns page
    QString dataFolder;    ///< of the user's own patterns and of what was not saved; empty: none is used
    QString study;         ///< folder of a study, or a protocol
    bool rehearse = false; ///< simulated participants go through the study
    std::optional<app::CameraRequest> camera; ///< to open
    QStringList arms;                         ///< files that describe arms, to open
    QStringList sites;                        ///< files with which sites are reached, to open
    QString cameraPairs;                      ///< to calibrate the cylinder camera with
    QStringList plotted;                      ///< signals for the Plot page, SOURCE/STREAM/COLUMN
    QString page;
    QString dock;     ///< of the Operate page, or a view of the Study page, brought to the front
    QString bracelet; ///< "simulated", "usb", "none" or a device file; empty: as the last time
    QString theme;
    QString language;
    QString screenshot;
    double after_s = 3.0;
    QSize size;
    std::optional<double> measure_s; ///< print the event loop's statistics after so long and quit
    bool freshLayout = false;        ///< start with default layout and settings and save nothing

    /// Names sources, a pattern, a study or pairs of a camera.
    [[nodiscard]] bool opensAnything() const {
        return !files.isEmpty() || !scenes.isEmpty() || !recordings.empty() || !sourceList.isEmpty() ||
               !pattern.isEmpty() || !study.isEmpty() || rehearse || camera || !arms.isEmpty() ||
               !sites.isEmpty() || !cameraPairs.isEmpty();
    }
};

/// Outcome of reading the command line: options, or a text to print and the exit code to leave with (0 for
/// --help and
/// --version, 2 for wrong usage).
struct ParsedOptions {
    std::optional<ConsoleOptions> options;
    QString text;
    int exitCode = 0;
};

/// Names of the pages for --page and the settings, in the order of the rail.
[[nodiscard]] QStringList pageNames();

[[nodiscard]] ParsedOptions parseOptions(const QStringList& arguments);

} // namespace teleta::console
