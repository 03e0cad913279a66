// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/preferences_dialog.h"

#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cstddef>

namespace teleta::console {

PreferencesDialog::PreferencesDialog(const Preferences& now,
                                     const std::vector<std::pair<QString, QString>>& languages,
                                     const QString& usualFolder, QWidget* parent)
    : QDialog(parent)
    , m_language(base::named<QComboBox>("language", this))
    , m_theme(base::named<QComboBox>("theme", this))
    , m_folder(base::named<QLineEdit>("recordingFolder", this))
    , m_start(base::named<QComboBox>("atStart", this))
    , m_screen(base::named<QCheckBox>("screen", tr("&Keep the screen on while something runs"), this))
    , m_utc(base::named<QCheckBox>("utc", tr("Add the &Unix time to exported CSV files"), this)) {
    setWindowTitle(tr("Preferences"));
    m_screen->setToolTip(tr("While a session runs, something is recorded, or an arm may move"));
    m_language->addItem(tr("As the desktop"), QString());
    for (const auto& [name, code] : languages)
        m_language->addItem(name, code);
    m_theme->addItem(tr("As the desktop"), QStringLiteral("system"));
    m_theme->addItem(tr("Light"), QStringLiteral("light"));
    m_theme->addItem(tr("Dark"), QStringLiteral("dark"));
    m_start->addItem(tr("Offer what was open last time"), static_cast<int>(AtStart::offer));
    m_start->addItem(tr("Open what was open last time"), static_cast<int>(AtStart::open));
    m_start->addItem(tr("Open nothing"), static_cast<int>(AtStart::nothing));
    m_utc->setToolTip(tr("A last column, utc_s, in seconds since 1970"));
    m_folder->setPlaceholderText(usualFolder);
    m_folder->setClearButtonEnabled(true);
    m_folder->setMinimumWidth(base::em(this, 24));
    auto* browse = base::named<QPushButton>("browse", tr("C&hoose\u2026"), this);
    browse->setAutoDefault(false);
    connect(browse, &QPushButton::clicked, this, [this, usualFolder] {
        const QString folder = m_folder->text().isEmpty() ? usualFolder : m_folder->text();
        base::askForFolder(this, {.title = tr("Folder of recordings"), .folder = folder},
                           [this](const QString& chosen) { m_folder->setText(chosen); });
    });

    auto* form = new QFormLayout;
    form->addRow(tr("Lan&guage:"), m_language);
    form->addRow(tr("&Theme:"), m_theme);
    form->addRow(tr("At the &start:"), m_start);
    auto* row = new QHBoxLayout;
    row->addWidget(m_folder, 1);
    row->addWidget(browse);
    base::addFormRow(*form, tr("&Folder of recordings:"), row, m_folder);
    for (QCheckBox* box : {m_utc, m_screen})
        form->setWidget(form->rowCount(), QFormLayout::FieldRole, box);
    auto* buttons = new QDialogButtonBox(
        QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
        setPreferences({.language = {}, .theme = QStringLiteral("system"), .recordingFolder = {}});
    });
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(buttons);
    // In the order in which they are seen.
    const std::array<QWidget*, 8> order{m_language, m_theme, m_start,  m_folder,
                                        browse,     m_utc,   m_screen, buttons};
    for (std::size_t i = 1; i < order.size(); ++i)
        setTabOrder(order[i - 1], order[i]);
    setPreferences(now);
}

void PreferencesDialog::setPreferences(const Preferences& preferences) {
    m_language->setCurrentIndex(std::max(0, m_language->findData(preferences.language)));
    m_theme->setCurrentIndex(std::max(0, m_theme->findData(preferences.theme)));
    m_folder->setText(preferences.recordingFolder);
    m_start->setCurrentIndex(m_start->findData(static_cast<int>(preferences.atStart)));
    m_screen->setChecked(preferences.keepsScreenOn);
    m_utc->setChecked(preferences.exportsUtc);
}

Preferences PreferencesDialog::preferences() const {
    return {.language = m_language->currentData().toString(),
            .theme = m_theme->currentData().toString(),
            .recordingFolder = m_folder->text().trimmed(),
            .atStart = static_cast<AtStart>(m_start->currentData().toInt()),
            .keepsScreenOn = m_screen->isChecked(),
            .exportsUtc = m_utc->isChecked()};
}

} // namespace teleta::console
