// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/pair_entry.h"

#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace teleta::console {

PairEntry::PairEntry(QWidget* parent)
    : QWidget(parent)
    , m_pixelLabel(new QLabel(this))
    , m_pointLabel(new QLabel(this))
    , m_add(base::named<QPushButton>("add", this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        auto* box = new QDoubleSpinBox(this);
        const bool pixel = i < 2;
        constexpr std::array<const char*, 5> kNames{"u", "v", "x", "y", "z"};
        box->setObjectName(QLatin1String(kNames[i]));
        box->setDecimals(2);
        box->setRange(pixel ? 0.0 : -10'000.0, pixel ? 100'000.0 : 10'000.0);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setAlignment(Qt::AlignRight);
        box->setMinimumWidth(base::em(this, 4.5));
        connect(box->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &PairEntry::add);
        m_fields[i] = box;
        if (i == 0)
            row->addWidget(m_pixelLabel);
        if (i == 2)
            row->addWidget(m_pointLabel);
        row->addWidget(box, 1);
    }
    row->addWidget(m_add);
    m_add->setAutoDefault(false);
    m_pixelLabel->setBuddy(m_fields[0]);
    m_pointLabel->setBuddy(m_fields[2]);
    connect(m_add, &QPushButton::clicked, this, &PairEntry::add);
    retranslate();
}

void PairEntry::add() {
    for (QDoubleSpinBox* box : m_fields)
        box->interpretText();
    emit entered({{m_fields[0]->value(), m_fields[1]->value()},
                  {1e-3 * m_fields[2]->value(), 1e-3 * m_fields[3]->value(), 1e-3 * m_fields[4]->value()}});
    m_fields[0]->setFocus();
    m_fields[0]->selectAll();
}

void PairEntry::retranslate() {
    m_pixelLabel->setText(tr("Pi&xel, px:"));
    m_pointLabel->setText(tr("&Point, mm:"));
    const std::array<QString, 5> names{tr("u, to the right"), tr("v, down"), tr("x of the point"),
                                       tr("y of the point"), tr("z of the point, along the tube")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_fields[i]->setAccessibleName(names[i]);
        m_fields[i]->setToolTip(names[i]);
    }
    m_add->setText(tr("A&dd pair"));
    m_add->setToolTip(tr("Add this pair (Enter)"));
}

} // namespace teleta::console
