// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/recent_list.h"

#include "widgets/base/compose.h"
#include "widgets/base/icons.h"
#include "widgets/base/mnemonics.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace teleta::chrome {

namespace {

constexpr double kListWidth_em = 10.0; ///< of a text, at most: four fit into a small window
constexpr QSizeF kRecentPicture_em(2.6, 1.7);

} // namespace

RecentList::RecentList(QWidget* parent)
    : QWidget(parent)
    , m_row(new QHBoxLayout(this))
    , m_title(new QLabel(this)) {
    m_row->setContentsMargins(base::grid(this, 2), 0, base::grid(this, 2), 0);
    m_row->addStretch(1);
    m_row->addWidget(m_title);
    m_row->addStretch(1);
    base::keepTranslated(this, &RecentList::rebuild);
    base::onChange(this, &RecentList::rebuild, {QEvent::FontChange, QEvent::PaletteChange});
}

void RecentList::setFiles(const QStringList& files) {
    m_files = files;
    rebuild();
}

void RecentList::setPicture(const QString& path, const QImage& picture) {
    if (!m_files.mid(0, kFiles).contains(path))
        return;
    m_pictures.insert(path, picture);
    rebuild();
}

void RecentList::setSession(const QString& names) {
    m_session = names;
    rebuild();
}

void RecentList::rebuild() {
    // One of the buttons may have asked for this.
    for (QToolButton* button : findChildren<QToolButton*>()) {
        m_row->removeWidget(button);
        button->hide();
        button->setObjectName(QString());
        button->deleteLater();
    }
    m_title->setText(tr("Recent:"));
    const auto add = [this](const QString& text, const QString& about, base::Icon icon, const char* name) {
        auto* button = base::named<QToolButton>(name, this);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setIcon(base::themeIcon(icon));
        button->setFocusPolicy(Qt::StrongFocus);
        const QString shown = fontMetrics().elidedText(text, Qt::ElideMiddle, base::em(this, kListWidth_em));
        button->setText(base::withoutMnemonic(shown));
        button->setAccessibleName(text);
        button->setAccessibleDescription(about);
        button->setToolTip(about);
        m_row->insertWidget(m_row->count() - 1, button);
        return button;
    };
    if (!m_session.isEmpty())
        connect(add(tr("Reopen %1", "what was open").arg(m_session),
                    tr("What was open when the console was closed"), base::Icon::operate, "reopenSession"),
                &QToolButton::clicked, this, &RecentList::sessionRequested);
    for (const QString& path : m_files.mid(0, kFiles)) {
        const bool isScene = path.endsWith(QLatin1String(".toml"), Qt::CaseInsensitive);
        QToolButton* button = add(QFileInfo(path).fileName(), path,
                                  isScene ? base::Icon::scene : base::Icon::recording, "recentFile");
        if (const QImage picture = m_pictures.value(path); !picture.isNull()) {
            button->setIconSize(
                QSize(base::em(this, kRecentPicture_em.width()), base::em(this, kRecentPicture_em.height())));
            button->setIcon(QPixmap::fromImage(picture));
        }
        connect(button, &QToolButton::clicked, this, [this, path] { emit fileRequested(path); });
    }
    setVisible(!m_session.isEmpty() || !m_files.isEmpty());
}

} // namespace teleta::chrome
