// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns_page.h"

#include "app/console/background.h"
#include "backend/pattern/built_in_patterns.h"
#include "backend/pattern/pattern_file.h"
#include "widgets/bracelet/bracelet_view.h"
#include "widgets/pattern/pattern_document.h"
#include "widgets/pattern/pattern_editor.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QVBoxLayout>

namespace teleta::console {

PatternsPage::PatternsPage(BraceletStation& station, QWidget* parent)
    : QWidget(parent)
    , m_station(station)
    , m_messages(new chrome::MessageBar(this))
    , m_editor(new editor::PatternEditor(this))
    , m_picture(new bracelet::BraceletView) {
    m_editor->setBraceletPicture(m_picture);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_editor, 1);

    connect(m_editor, &editor::PatternEditor::playRequested, this, [this](const pattern::Pattern& pattern) {
        if (m_station.isReady())
            m_station.play(pattern, m_editor->looping());
        m_editor->setPlaying(m_station.isReady());
    });
    connect(m_editor, &editor::PatternEditor::stopRequested, this, [this] {
        m_station.stopPlaying();
        m_editor->setPlaying(false);
    });
    connect(m_editor, &editor::PatternEditor::openRequested, this, [this](const QString& idOrPath) {
        if (idOrPath.isEmpty())
            askForFile(false);
        else
            open(idOrPath);
    });
    connect(m_editor, &editor::PatternEditor::saveRequested, this, [this](const QString& path) {
        if (path.isEmpty())
            askForFile(true);
        else
            save(path);
    });
    connect(m_editor->document(), &editor::PatternDocument::refused, this, [this](const QString& message) {
        m_messages->post({chrome::Message::Severity::warning, message, {}, {}});
    });
    connect(m_picture, &bracelet::BraceletView::held, &m_station, &BraceletStation::hold);
    open(QString::fromStdString(pattern::builtInPatterns().front().id));
}

void PatternsPage::open(const QString& idOrPath) {
    if (const pattern::Pattern* builtIn = pattern::findBuiltIn(idOrPath.toStdString())) {
        m_editor->document()->setPattern(*builtIn);
        return;
    }
    runInBackground(
        this, [idOrPath] { return pattern::loadPattern(idOrPath.toStdString()); },
        [this, idOrPath](core::Expected<pattern::Pattern> pattern) {
            if (pattern)
                m_editor->document()->setPattern(*pattern, idOrPath);
            else
                report(tr("%1 could not be opened.", "a file").arg(QFileInfo(idOrPath).fileName()),
                       pattern.error());
        });
}

void PatternsPage::save(const QString& path) {
    runInBackground(
        this,
        [path, pattern = m_editor->document()->pattern()] {
            return pattern::savePattern(pattern, path.toStdString());
        },
        [this, path, revision = m_editor->document()->revision()](core::Expected<void> saved) {
            if (!saved)
                report(tr("%1 could not be saved.", "a file").arg(QFileInfo(path).fileName()), saved.error());
            else if (revision == m_editor->document()->revision())
                m_editor->document()->markSaved(path);
        });
}

void PatternsPage::askForFile(bool save) {
    auto* dialog = new QFileDialog(this, save ? tr("Save pattern") : tr("Open pattern"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(save ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Patterns (*.json)"), tr("HJIF (*.hjif)"), tr("Haptic clips (*.haptic.zip)"),
                            tr("tact (*.tact)")});
    if (save)
        dialog->setDefaultSuffix(QStringLiteral("json"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, save](const QString& path) {
        if (save)
            this->save(path);
        else
            open(path);
    });
    dialog->open();
}

void PatternsPage::report(const QString& what, const core::Error& error) {
    m_messages->post(
        {chrome::Message::Severity::error, what, QString::fromStdString(core::describe(error)), QString()});
}

void PatternsPage::tick() {
    const auto playing = m_station.playingPosition_s();
    if (m_editor->isPlaying() != playing.has_value())
        m_editor->setPlaying(playing.has_value());
    if (playing)
        m_editor->setPlayhead(*playing);
    m_picture->setIntensities(m_station.given());
    m_picture->setNote(m_station.note());
    m_picture->setHoldable(m_station.isReady());
    m_picture->setTitle(QString::fromStdString(m_editor->document()->pattern().name));
    m_picture->setProvenance(m_station.isSimulated() ? base::Provenance::simulated : base::Provenance::live);
}

} // namespace teleta::console
