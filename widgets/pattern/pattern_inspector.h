// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/compose.h"
#include "widgets/pattern/document/pattern_document.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

namespace teleta::pattern {

/// Intensities are shown in percent.
inline constexpr double kPercent = 100.0;

/// Fields of a document: name, length, tags and notes of the pattern, and below them the selection: one
/// breakpoint, several, or an object with all its parameters. Thread: GUI.
class PatternInspector : public QWidget {
    Q_OBJECT
public:
    explicit PatternInspector(PatternDocument* document, QWidget* parent = nullptr);

    /// Shows the range of the loop; emits nothing.
    void setLoop(const std::optional<Span>& loop);

signals:
    /// The user has typed another loop; equal begin and end mean none.
    void loopEdited(double begin_s, double end_s);

private:
    void showPattern();
    void showSelection();
    void rebuild();
    /// What the rows are for: nothing, a breakpoint, several of them, or an object of one form.
    [[nodiscard]] QString kindOfSelection() const;
    void buildPoints();
    void buildObject();
    /// Adds a row with a number from the document; set is called when the user changes it.
    QDoubleSpinBox* number(const char* name, const QString& label, const QString& unit, double low,
                           double high, int decimals, std::function<double()> get,
                           std::function<void(double)> set);
    [[nodiscard]] QComboBox* easingBox(const char* name);
    /// The rows of one kind of object only.
    void buildForm(const Sweep& form);
    void buildForm(const Ring& form);
    void buildForm(const Phantom& form);
    void buildForm(const Ramp& form);
    void buildForm(const PulseTrain& form);
    void buildForm(const Stroke& stroke);
    /// The selected object when it is of this form.
    template <typename Form>
    [[nodiscard]] const Form* selectedForm() const;
    /// field: as for PatternDocument::replaceObject().
    template <typename Form, typename Change>
    void change(Change change, const QString& field = {});
    template <typename Form>
    void check(const char* name, const QString& label, std::function<bool(const Form&)> get,
               std::function<void(Form&, bool)> set);
    template <typename Form>
    void motor(const char* name, const QString& label, int Form::*tactor);
    template <typename Form>
    void field(const char* name, const QString& label, const QString& unit, double low, double high,
               int decimals, std::function<double(const Form&)> get, std::function<void(Form&, double)> set);
    /// The same for a member; with the unit % in percent.
    template <typename Form>
    void field(const char* name, const QString& label, const QString& unit, double low, double high,
               int decimals, double Form::*value);
    template <typename Form>
    void tactors();

    PatternDocument* m_document;
    QFormLayout* m_top = new QFormLayout; ///< rows of the pattern
    QLabel* m_title = new QLabel(this);
    QLineEdit* m_name = base::named<QLineEdit>("name", this);
    QDoubleSpinBox* m_duration = base::named<QDoubleSpinBox>("duration", this);
    QDoubleSpinBox* m_loopBegin = base::named<QDoubleSpinBox>("loopBegin", this);
    QDoubleSpinBox* m_loopEnd = base::named<QDoubleSpinBox>("loopEnd", this);
    QComboBox* m_task = base::named<QComboBox>("task", this);
    QComboBox* m_condition = base::named<QComboBox>("condition", this);
    QLineEdit* m_tags = base::named<QLineEdit>("tags", this);
    QPlainTextEdit* m_notes = new QPlainTextEdit(this);
    QWidget* m_rows = nullptr;
    QFormLayout* m_form = nullptr;
    std::vector<std::function<void()>> m_refresh;
    QString m_kind;                ///< kindOfSelection() of the rows
    std::size_t m_strokePoint = 0; ///< index of the shown point of a stroke
    bool m_showing = false;
};

} // namespace teleta::pattern
