// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol/exclusion_rule.h"

#include <QGroupBox>

#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace teleta::console {

/// The rules of a protocol that say what does not count, as a form: one row for each, in the order in which
/// they apply. Values are written with a point; the reader of protocol files checks them. Thread: GUI.
class ExclusionEditor : public QGroupBox {
    Q_OBJECT

public:
    explicit ExclusionEditor(const std::vector<study::ExclusionRule>& rules, QWidget* parent = nullptr);

    /// Error: refused for a value that is not a number.
    [[nodiscard]] core::Expected<std::vector<study::ExclusionRule>> rules() const;

signals:
    void changed();

private:
    struct Row {
        QWidget* box;
        QLineEdit* id;
        QComboBox* kind; ///< in the order of study::ExclusionKind
        QLineEdit* value;
    };

    void add(const study::ExclusionRule& rule);
    [[nodiscard]] std::string freeId() const;
    void remove(QWidget* box);

    std::vector<Row> m_rows;
    QVBoxLayout* m_list;
    QLabel* m_none;
};

} // namespace teleta::console
