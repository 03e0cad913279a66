// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"

#include <QDialog>
#include <QString>

#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace teleta::console {

/// What the dialog of preferences sets.
struct Preferences {
    QString language = {};        ///< "en", "fr", "ja", "zh_CN"; empty: the desktop's
    QString theme = {};           ///< "light", "dark", "system"
    QString recordingFolder = {}; ///< empty: the usual folder
    AtStart atStart = AtStart::offer;
    bool keepsScreenOn = true;
    bool exportsUtc = false; ///< CSV files of recordings get a column of Unix times

    bool operator==(const Preferences&) const = default;
};

/// The settings that are not about one source, in one place. Nothing changes before it is accepted. Thread:
/// GUI.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    /// languages: {own name, code}. usualFolder: where recordings go when no folder was chosen.
    PreferencesDialog(const Preferences& now, const std::vector<std::pair<QString, QString>>& languages,
                      const QString& usualFolder, QWidget* parent);

    [[nodiscard]] Preferences preferences() const;

private:
    void setPreferences(const Preferences& preferences);

    QComboBox* m_language;
    QComboBox* m_theme;
    QLineEdit* m_folder;
    QComboBox* m_start;
    QCheckBox* m_screen;
    QCheckBox* m_utc;
};

} // namespace teleta::console
