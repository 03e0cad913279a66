// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/import_dialog.h"

#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::console {

namespace {

/// The tactors that have anything to play.
std::vector<std::size_t> playingTactors(const pattern::Pattern& pattern) {
    std::vector<std::size_t> tactors;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const bool hasObject =
            std::ranges::any_of(pattern.objects, [i](const pattern::PatternObject& object) {
                const auto* ramp = std::get_if<pattern::Ramp>(&object.form);
                return ramp != nullptr && std::ranges::count(ramp->tactors, static_cast<int>(i)) > 0;
            });
        if (hasObject || !pattern.tracks[i].empty())
            tactors.push_back(i);
    }
    return tactors;
}

} // namespace

ImportDialog::ImportDialog(const QString& fileName, const pattern::PatternImport& import, QWidget* parent)
    : QDialog(parent)
    , m_readArm(import.pattern.arm)
    , m_readTactors(playingTactors(import.pattern))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Open pattern"));
    auto* about = new QLabel(
        tr("A pattern cannot represent everything that %1 holds. Opening it changes or leaves out:", "a file")
            .arg(fileName),
        this);
    about->setWordWrap(true);
    auto* losses = base::named<QListWidget>("losses", this);
    losses->setWordWrap(true);
    losses->setMinimumWidth(base::em(this, 36));
    for (const pattern::Loss& loss : import.losses)
        losses->addItem(QString::fromStdString(describe(loss)));
    about->setBuddy(losses);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(about);
    layout->addWidget(losses, 1);
    addChoices(import);
    layout->addWidget(m_buttons);
    m_buttons->button(QDialogButtonBox::Open)->setDefault(true);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ImportDialog::addChoices(const pattern::PatternImport& import) {
    auto* form = new QFormLayout;
    if (import.bothArms) {
        m_arm = base::named<QComboBox>("arm", this);
        m_arm->addItem(tr("left"), static_cast<int>(pattern::Arm::left));
        m_arm->addItem(tr("right"), static_cast<int>(pattern::Arm::right));
        m_arm->setCurrentIndex(m_arm->findData(static_cast<int>(m_readArm)));
        form->addRow(tr("&Arm:"), m_arm);
    }
    if (import.oneSignal) {
        auto* row = new QHBoxLayout;
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            auto* box = new QCheckBox(QString::number(i + 1), this);
            box->setObjectName(QStringLiteral("tactor%1").arg(i + 1));
            box->setChecked(std::ranges::count(m_readTactors, i) > 0);
            connect(box, &QCheckBox::toggled, this, [this] {
                m_buttons->button(QDialogButtonBox::Open)->setEnabled(!options().tactors.empty());
            });
            row->addWidget(box);
            m_tactors.push_back(box);
        }
        base::addFormRow(*form, tr("&Motors:"), row, m_tactors.front());
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

pattern::ImportOptions ImportDialog::options() const {
    pattern::ImportOptions options;
    if (m_arm != nullptr)
        options.arm = static_cast<pattern::Arm>(m_arm->currentData().toInt());
    for (std::size_t i = 0; i < m_tactors.size(); ++i) {
        if (m_tactors[i]->isChecked())
            options.tactors.push_back(i);
    }
    return options;
}

bool ImportDialog::isChanged() const {
    const pattern::ImportOptions chosen = options();
    return (chosen.arm && *chosen.arm != m_readArm) ||
           (!m_tactors.empty() && chosen.tactors != m_readTactors);
}

} // namespace teleta::console
