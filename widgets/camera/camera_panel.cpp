// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/camera_panel.h"

#include "backend/vision/finders/contact_ladder.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/camera/camera_view.h"
#include "widgets/camera/finder_names.h"
#include "widgets/camera/reaction_row.h"
#include "widgets/camera/stage_bar.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

namespace teleta::camera {

namespace {

/// Of a finder that have room without the list; longer titles are cut there.
constexpr int kTitleLetters = 14;

QString nameOf(std::string_view rung) {
    return QString::fromLatin1(rung.data(), static_cast<qsizetype>(rung.size()));
}

} // namespace

CameraPanel::CameraPanel(QWidget* parent)
    : QWidget(parent)
    , m_rungs(new QComboBox(this))
    , m_pause(new QToolButton(this))
    , m_arrows(new QCheckBox(this))
    , m_reference(new QPushButton(this))
    , m_rungName(new QLabel(this))
    , m_problem(new QLabel(this))
    , m_arm(new ReactionRow(this))
    , m_view(new CameraView(this))
    , m_stages(new StageBar(this)) {
    m_rungs->setObjectName(QStringLiteral("cameraRung"));
    m_pause->setObjectName(QStringLiteral("cameraPause"));
    m_arrows->setObjectName(QStringLiteral("cameraArrows"));
    m_reference->setObjectName(QStringLiteral("cameraReference"));
    m_problem->setObjectName(QStringLiteral("problem"));
    m_pause->setCheckable(true);
    m_arrows->setChecked(true);
    m_problem->setWordWrap(true);
    for (const vision::ContactRung& rung : vision::contactLadder())
        m_rungs->addItem(QString(), nameOf(rung.name));
    m_rungs->setItemDelegate(new FinderDelegate(m_rungs));
    m_rungs->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_rungs->setMinimumContentsLength(kTitleLetters);
    m_rungName->setBuddy(m_rungs);

    const int margin = base::grid(this);
    auto* tools = new QHBoxLayout;
    tools->setSpacing(margin);
    tools->addWidget(m_rungName);
    tools->addWidget(m_rungs);
    tools->addWidget(m_arrows);
    tools->addStretch(1);
    tools->addWidget(m_reference);
    tools->addWidget(m_pause);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin / 2, margin, margin / 2);
    layout->setSpacing(margin / 2);
    layout->addLayout(tools);
    layout->addWidget(m_problem);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_arm);
    layout->addWidget(m_stages);
    setFocusProxy(m_view);

    connect(m_rungs, &QComboBox::activated, this, [this] {
        m_wish = m_rungs->currentData().toString();
        emit rungChosen(m_wish);
    });
    connect(m_pause, &QToolButton::toggled, this, &CameraPanel::setPaused);
    connect(m_view, &CameraView::pauseRequested, this, &CameraPanel::setPaused);
    connect(m_view, &CameraView::exportFailed, this, &CameraPanel::exportFailed);
    connect(m_arrows, &QCheckBox::toggled, m_view, &CameraView::setArrowsShown);
    connect(m_reference, &QPushButton::clicked, this, &CameraPanel::referenceRequested);
    connect(m_arm, &ReactionRow::mayReactChanged, this, &CameraPanel::mayReactChanged);
    base::keepTranslated(this, &CameraPanel::retranslate);
    setSnapshot(nullptr);
    base::onChange(this, &CameraPanel::showTexts, {QEvent::PaletteChange});
}

void CameraPanel::setSnapshot(const pipeline::CameraSnapshot* snapshot, double nominalRate_Hz) {
    m_view->setSnapshot(snapshot);
    m_stages->setSnapshot(snapshot, nominalRate_Hz);
    m_hasCamera = snapshot != nullptr;
    setEnabled(m_hasCamera);
    m_arm->set(snapshot != nullptr ? snapshot->carrier : std::nullopt,
               snapshot != nullptr && snapshot->mayReact);
    if (snapshot == nullptr) {
        m_why.clear();
        m_whyRefused.clear();
        m_nextRung.clear();
        m_wish.clear();
        setPaused(false);
    } else {
        m_why = QString::fromStdString(snapshot->problem);
        m_hasReference = snapshot->hasReference;
        const QString rung = nameOf(snapshot->rung);
        m_whyRefused = QString::fromStdString(snapshot->whyRefused);
        m_nextRung = nameOf(snapshot->nextRung);
        // After a refusal the box shows the rung in use again.
        if (m_wish == rung || m_wish == nameOf(snapshot->refusedRung))
            m_wish.clear();
        if (m_wish.isEmpty() && m_rungs->currentData() != rung)
            m_rungs->setCurrentIndex(m_rungs->findData(rung));
    }
    showTexts();
}

void CameraPanel::setProvenance(base::Provenance provenance) {
    m_view->setProvenance(provenance);
}

bool CameraPanel::isPaused() const {
    return m_pause->isChecked();
}

void CameraPanel::setPaused(bool paused) {
    const QSignalBlocker blocked(m_pause);
    m_pause->setChecked(paused);
    m_pause->setText(paused ? tr("Resume") : tr("Pause"));
    m_view->setPaused(paused);
}

void CameraPanel::showTexts() {
    const base::StatusColours& colours = base::statusColours(palette());
    QString problem;
    const bool isLost = !m_hasReference || !m_why.isEmpty() || !m_whyRefused.isEmpty();
    if (!m_hasCamera)
        problem.clear();
    else if (!m_hasReference)
        problem = m_why.isEmpty() ? tr("Waiting for a picture of the tube with nothing touching it.")
                                  : tr("No reference yet: %1").arg(m_why);
    else if (!m_why.isEmpty())
        problem = tr("Picture not used: %1").arg(m_why);
    else if (!m_whyRefused.isEmpty())
        problem = tr("This finder cannot be used: %1").arg(m_whyRefused);
    else if (!m_nextRung.isEmpty())
        problem = tr("Preparing the finder: %1.").arg(m_rungs->itemText(m_rungs->findData(m_nextRung)));
    m_problem->setText(problem);
    m_problem->setToolTip(problem); // where a low dock cuts it
    m_problem->setVisible(!problem.isEmpty());
    base::setTextColour(m_problem, isLost ? colours.lost : palette().color(QPalette::WindowText));
}

void CameraPanel::retranslate() {
    m_rungName->setText(tr("F&inder"));
    m_rungs->setAccessibleName(tr("Finder"));
    m_rungs->setToolTip(tr("How contacts are found: from the printed dots alone, or with dense flow by one "
                           "of OpenCV's presets; the number is how many times the image is reduced"));
    QString all;
    for (const vision::ContactRung& rung : vision::contactLadder()) {
        const QString title = FinderNames::title(rung);
        const QString text = FinderNames::explanation(rung);
        const int place = m_rungs->findData(nameOf(rung.name));
        m_rungs->setItemText(place, title);
        m_rungs->setItemData(place, FinderNames::cost(rung), FinderDelegate::kCost);
        m_rungs->setItemData(place, text, Qt::ToolTipRole);
        all += QStringLiteral("<p><b>%1</b> (%2): %3</p>")
                   .arg(title, nameOf(rung.name), QString(text).replace(u'\n', QStringLiteral(". ")));
    }
    m_rungs->view()->setMinimumWidth(m_rungs->view()->sizeHintForColumn(0) +
                                     style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this));
    m_rungs->setWhatsThis(QStringLiteral("<p>%1</p>").arg(m_rungs->toolTip()) + all);
    m_arrows->setText(tr("&Displacement"));
    m_arrows->setToolTip(tr("Show how far the pattern on the skin has moved"));
    m_reference->setText(tr("Ne&w reference"));
    m_reference->setToolTip(tr("Take the next picture as the reference: nothing may touch the tube"));
    m_pause->setText(m_pause->isChecked() ? tr("Resume") : tr("Pause"));
    m_pause->setToolTip(tr("Freeze the picture; contacts are still tracked (Space)"));
    showTexts();
}

} // namespace teleta::camera
