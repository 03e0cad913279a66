// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/start/recent_list.h"

#include "widgets/base/compose.h"
#include "widgets/base/icons.h"
#include "widgets/base/mnemonics.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace teleta::chrome {

namespace {

constexpr double kListWidth_em = 12.0; ///< of a text: four fit into a small window
constexpr double kMostWidth_em = 30.0; ///< where there is room
constexpr double kBesideText_em = 5.0; ///< icon and margins of a button
constexpr QSizeF kRecentPicture_em(2.6, 1.7);

} // namespace

RecentList::RecentList(QWidget* parent)
    : QWidget(parent)
    , m_row(new QHBoxLayout(this))
    , m_title(new QLabel(this))
    , m_reopen(base::named<QToolButton>("reopenSession", this)) {
    m_row->setContentsMargins(base::grid(this, 2), 0, base::grid(this, 2), 0);
    m_row->addStretch(1);
    m_row->addWidget(m_title);
    m_row->addWidget(m_reopen);
    m_row->addStretch(1);
    connect(m_reopen, &QToolButton::clicked, this, &RecentList::sessionRequested);
    base::keepTranslated(this, &RecentList::retranslate);
    base::onChange(this, &RecentList::retranslate, {QEvent::FontChange, QEvent::PaletteChange});
}

/// The button of a file that stays is kept, with its focus.
void RecentList::setFiles(const QStringList& paths) {
    std::vector<File> before = std::exchange(m_files, {});
    for (const QString& path : paths.mid(0, kFiles)) {
        const auto known = std::ranges::find(before, path, &File::path);
        if (known != before.end()) {
            m_files.push_back(*known);
            before.erase(known);
        } else {
            auto* button = base::named<QToolButton>("recentFile", this);
            connect(button, &QToolButton::clicked, this, [this, path] { emit fileRequested(path); });
            m_files.push_back({path, button, {}});
        }
    }
    for (const File& gone : before) {
        // It may be the one that asked for this.
        gone.button->hide();
        gone.button->setObjectName(QString());
        gone.button->deleteLater();
    }
    QWidget* previous = m_reopen;
    for (const File& file : m_files) {
        m_row->removeWidget(file.button);
        m_row->insertWidget(m_row->count() - 1, file.button);
        setTabOrder(previous, file.button);
        previous = file.button;
    }
    retranslate();
}

void RecentList::setPicture(const QString& path, const QImage& picture) {
    const auto file = std::ranges::find(m_files, path, &File::path);
    if (file == m_files.end())
        return;
    file->picture = picture;
    retranslate();
}

void RecentList::setSession(const QString& names) {
    m_session = names;
    retranslate();
}

void RecentList::setNames(const RecentNames& names) {
    m_names = names;
    retranslate();
}

void RecentList::fill(QToolButton& button, const RecentName& name, const QString& about, const QIcon& icon) {
    button.setAutoRaise(true);
    button.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button.setIcon(icon);
    button.setFocusPolicy(Qt::StrongFocus);
    const auto shown = [this](const QString& text) {
        return base::withoutMnemonic(fontMetrics().elidedText(text, Qt::ElideMiddle, textWidth()));
    };
    button.setText(name.about.isEmpty() ? shown(name.title)
                                        : shown(name.title) + QLatin1Char('\n') + shown(name.about));
    button.setAccessibleName(name.oneLine());
    button.setAccessibleDescription(about);
    button.setToolTip(about);
}

int RecentList::textWidth() const {
    const int buttons = std::max(1, static_cast<int>(m_files.size()) + (m_session.isEmpty() ? 0 : 1));
    const int room = (width() - m_title->sizeHint().width()) / buttons - base::em(this, kBesideText_em);
    return std::clamp(room, base::em(this, kListWidth_em), base::em(this, kMostWidth_em));
}

void RecentList::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->oldSize().width() != event->size().width())
        retranslate();
}

void RecentList::retranslate() {
    m_title->setText(tr("Recent:"));
    fill(*m_reopen, {tr("Reopen %1", "what was open").arg(m_session), {}, {}},
         tr("What was open when the console was closed"), base::themeIcon(base::Icon::operate));
    m_reopen->setVisible(!m_session.isEmpty());
    QStringList paths;
    for (const File& file : m_files)
        paths << file.path;
    const QList<RecentName> names = recentNamesOf(paths, m_names);
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        const File& file = m_files[i];
        const bool isScene = file.path.endsWith(QLatin1String(".toml"), Qt::CaseInsensitive);
        const bool hasPicture = !file.picture.isNull();
        if (hasPicture)
            file.button->setIconSize(
                QSize(base::em(this, kRecentPicture_em.width()), base::em(this, kRecentPicture_em.height())));
        fill(*file.button, names[static_cast<qsizetype>(i)], file.path,
             hasPicture ? QIcon(QPixmap::fromImage(file.picture))
                        : base::themeIcon(isScene ? base::Icon::scene : base::Icon::recording));
    }
    setVisible(!m_session.isEmpty() || !m_files.empty());
}

} // namespace teleta::chrome
