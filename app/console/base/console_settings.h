// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/source_request.h"
#include "backend/frames/frame_request.h"

#include <QByteArray>
#include <QMap>
#include <QSettings>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <string>

namespace teleta::console {

/// What becomes, at the start, of what was open when the console was closed.
enum class AtStart {
    offer, ///< a button opens it
    open,  ///< it is opened
    nothing,
};

/// What the console remembers from one start to the next, in an INI file under the user's configuration
/// folder. Versioned: those of older versions are taken over, a newer file is left alone and the defaults
/// used. Of a damaged file a copy stays beside it (console.ini.damaged), and what can be read is used; the
/// user is told of both, and when the file cannot be written. Of several consoles that run each writes what
/// it changed; where that is the same, the last one counts. Thread: GUI; QSettings writes the file by itself,
/// atomically.
class ConsoleSettings {
public:
    static constexpr int kVersion = 1;
    static constexpr int kRecentFiles = 8; ///< of each kind, at most

    /// fresh: remember nothing and start with the defaults.
    explicit ConsoleSettings(bool fresh);

    /// How the file was found.
    enum class Found {
        usable,
        damaged,
        newer,
        unwritable, ///< what is remembered is forgotten at the end
    };
    [[nodiscard]] Found found() const { return m_found; }
    /// Of a damaged file its copy, empty when none could be made; else the file. Empty when fresh.
    [[nodiscard]] QString keptFile() const { return m_keptFile; }

    [[nodiscard]] QString theme() const { return text("theme", QStringLiteral("system")); }
    void setTheme(const QString& theme) { set("theme", theme); }
    [[nodiscard]] QString language() const { return text("language", {}); }
    void setLanguage(const QString& language) { set("language", language); }
    [[nodiscard]] QString page() const { return text("page", {}); }
    void setPage(const QString& page) { set("page", page); }

    [[nodiscard]] QByteArray geometry() const { return bytes("window/geometry"); }
    void setGeometry(const QByteArray& geometry) { set("window/geometry", geometry); }
    /// Dock layout of a page.
    [[nodiscard]] QByteArray layout(const QString& page) const { return bytes("layout/" + page); }
    void setLayout(const QString& page, const QByteArray& layout) { set("layout/" + page, layout); }

    /// Names of the first steps that were done, and whether the start page shows them.
    [[nodiscard]] QStringList firstStepsDone() const { return list(QStringLiteral("start/done")); }
    void setFirstStepsDone(const QStringList& names) { set("start/done", names); }
    [[nodiscard]] bool showsFirstSteps() const { return flag("start/steps", true); }
    void setShowsFirstSteps(bool shows) { set("start/steps", shows); }
    /// Names of what is switched off in the 3-D view.
    [[nodiscard]] QStringList hiddenLayers() const { return list(QStringLiteral("view3d/hidden")); }
    void setHiddenLayers(const QStringList& names) { set("view3d/hidden", names); }

    /// Layouts of the docks of the Operate page that have a name.
    [[nodiscard]] QMap<QString, QByteArray> namedLayouts() const;
    /// An empty layout takes the name away.
    void setNamedLayout(const QString& name, const QByteArray& layout);
    /// Layouts of the Plot page, as JSON, by name. An empty layout takes the name away.
    [[nodiscard]] QMap<QString, QByteArray> plotLayouts() const;
    void setPlotLayout(const QString& name, const QByteArray& layout);

    /// What was open when the console was closed, see last_session.
    [[nodiscard]] QStringList lastSession() const { return list(QStringLiteral("session/open")); }
    void setLastSession(const QStringList& entries) { set("session/open", entries); }
    [[nodiscard]] AtStart atStart() const;
    void setAtStart(AtStart choice);
    [[nodiscard]] bool keepsScreenOn() const { return flag("screen/keep", true); }
    void setKeepsScreenOn(bool keeps) { set("screen/keep", keeps); }
    /// Whether exported CSV files have a column of Unix times.
    [[nodiscard]] bool exportsUtc() const { return flag("export/utc", false); }
    void setExportsUtc(bool exports) { set("export/utc", exports); }

    /// "simulated", "hid", "none", "file:FILE"; of the first versions "modbus:FILE".
    [[nodiscard]] QString bracelet() const { return text("bracelet", QStringLiteral("simulated")); }
    void setBracelet(const QString& bracelet) { set("bracelet", bracelet); }
    /// Motor drivers that were opened, the newest first.
    [[nodiscard]] QStringList deviceFiles() const;
    void addDeviceFile(const QString& path);
    /// Which pattern tells what was recognised, as JSON; empty: the default.
    [[nodiscard]] QString patternMap() const { return text("feedback/map", {}); }
    void setPatternMap(const QString& json) { set("feedback/map", json); }
    /// "both", "stiffness", "shape", "off".
    [[nodiscard]] QString feedbackMode() const { return text("feedback/mode", QStringLiteral("both")); }
    void setFeedbackMode(const QString& mode) { set("feedback/mode", mode); }

    /// Recordings, scenes and source lists, the newest first.
    [[nodiscard]] QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    /// Folders of studies, the newest first.
    [[nodiscard]] QStringList recentStudies() const;
    void addRecentStudy(const QString& folder);
    /// Forgets files, patterns and studies.
    void clearRecent();

    /// Where recordings are kept; empty: nobody chose a folder.
    [[nodiscard]] QString recordingFolder() const { return text("recording/folder", {}); }
    void setRecordingFolder(const QString& folder) { set("recording/folder", folder); }

    /// Pattern files, the newest first.
    [[nodiscard]] QStringList recentPatterns() const;
    void addRecentPattern(const QString& path);

    /// How a recording was opened the last time.
    [[nodiscard]] std::optional<app::CsvRequest> recording(const QString& path) const;
    void setRecording(const app::CsvRequest& request);

    /// What was said last about a file of frames of this family, see frames::familyOf(); without a path.
    [[nodiscard]] std::optional<frames::FrameRequest> frameRequest(const std::string& family) const;
    void setFrameRequest(const std::string& family, const frames::FrameRequest& request);

    /// The camera that was opened the last time.
    [[nodiscard]] app::CameraRequest camera() const {
        return {text("camera/source", {}).toStdString(), text("camera/model", {}).toStdString(), true};
    }
    void setCamera(const app::CameraRequest& request) {
        set("camera/source", QString::fromStdString(request.source));
        set("camera/model", QString::fromStdString(request.modelPath));
    }

private:
    [[nodiscard]] QString text(const QString& key, const QString& fallback) const;
    [[nodiscard]] QByteArray bytes(const QString& key) const;
    [[nodiscard]] bool flag(const QString& key, bool fallback) const;
    void set(const QString& key, const QVariant& value);
    [[nodiscard]] QMap<QString, QByteArray> named(const QString& key) const;
    void setNamed(const QString& key, const QString& name, const QByteArray& layout);
    [[nodiscard]] QStringList list(const QString& key) const;
    void addToList(const QString& key, const QString& path);

    std::unique_ptr<QSettings> m_settings; ///< null when fresh, or the file is a newer version's
    Found m_found = Found::usable;
    QString m_keptFile;
};

} // namespace teleta::console
