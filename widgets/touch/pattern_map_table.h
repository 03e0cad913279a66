// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/shape_recogniser.h"
#include "backend/core/error.h"
#include "backend/pattern/model/pattern_map.h"

#include <QUndoStack>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace teleta::touch {

/// A pattern that may be played.
struct PatternChoice {
    std::string id;
    QString name;
    QString task;      ///< words for the preview: "stiffness"
    QString condition; ///< "dynamic"
};

/// What was recognised and the pattern that tells it to the wearer: five levels of stiffness and the shapes,
/// each with a choice of patterns. The row that was recognised last is marked, and the pattern that would be
/// played now is named, also without a bracelet. Every edit can be undone. Thread: GUI.
class PatternMapTable : public QWidget {
    Q_OBJECT
public:
    static constexpr int kRows =
        static_cast<int>(pattern::kStiffnessLevels + pattern::kRecognisedShapes.size() + 1);

    explicit PatternMapTable(QWidget* parent = nullptr);

    void setChoices(std::vector<PatternChoice> choices);
    /// Shows a map and forgets the edits. Emits nothing.
    void setMap(const pattern::PatternMap& map);
    [[nodiscard]] const pattern::PatternMap& map() const { return m_map; }
    /// Chooses the pattern of a row, as the user would. Rows: the levels from soft to hard, the shapes,
    /// unknown stiffness.
    void choose(int row, const std::string& id);
    void resetToDefaults();

    void setRecognisedStiffness(int level);
    void setRecognisedShape(contour::Shape shape);
    void setUnknownStiffness();
    void clearRecognised() { recognise(std::nullopt); }
    [[nodiscard]] std::optional<int> recognisedRow() const { return m_recognised; }
    /// Id of the pattern that would be played now; empty: none.
    [[nodiscard]] std::string patternNow() const;
    /// The same in words, as shown.
    [[nodiscard]] QString textNow() const;

    /// Reads a map from a file, as one edit. Error: ioFailed; badInput with the place.
    [[nodiscard]] core::Expected<void> importFrom(const QString& path);
    /// The file is complete or it is not there. Error: ioFailed.
    [[nodiscard]] core::Expected<void> exportTo(const QString& path) const;

    [[nodiscard]] QUndoStack* undoStack() const { return m_undo; }
    [[nodiscard]] QComboBox* box(int row) const { return m_boxes[static_cast<std::size_t>(row)]; }
    [[nodiscard]] QTableWidget* table() const { return m_table; }

signals:
    void mapChanged();
    void exported(const QString& path);
    void failed(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void edit(const pattern::PatternMap& map, const QString& what);
    void take(const pattern::PatternMap& map);
    [[nodiscard]] const PatternChoice* choiceOf(const std::string& id) const;
    [[nodiscard]] static QString rowName(int row);
    void askForFile(bool save);
    void fillBoxes();
    void showMap();
    void recognise(std::optional<int> row);
    void showRecognised();
    void showKinds();
    void retranslate();

    pattern::PatternMap m_map = pattern::PatternMap::defaults();
    std::vector<PatternChoice> m_choices;
    std::optional<int> m_recognised;
    QUndoStack* m_undo;
    QTableWidget* m_table;
    std::vector<QComboBox*> m_boxes;
    QLabel* m_now;
    QPushButton* m_undoButton;
    QPushButton* m_redoButton;
    QPushButton* m_reset;
    QPushButton* m_import;
    QPushButton* m_export;
};

} // namespace teleta::touch
