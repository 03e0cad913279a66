// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/kept_picture.h"
#include "widgets/base/figure/sized_view.h"
#include "widgets/study/participant/participant_scene.h"

namespace teleta::study {

/// One answer: letter, name, digit and picture of the pattern. The window handles the input. Thread: GUI.
class AnswerButton : public base::SizedView {
    Q_OBJECT

public:
    enum class Look {
        plain,
        right,  ///< feedback: this was presented
        wrong,  ///< feedback: this was answered and not presented
        chosen, ///< answered, without feedback
        lit,    ///< its interval is felt now
    };

    AnswerButton(AnswerChoice choice, std::size_t digit, QWidget* parent = nullptr);

    void setDiagramShown(bool shown);
    void setOpen(bool open);
    void setLook(Look look);
    [[nodiscard]] Look look() const { return m_look; }
    [[nodiscard]] bool isOpen() const { return m_open; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    AnswerChoice m_choice;
    base::KeptPicture m_diagram;
    std::size_t m_digit;
    bool m_diagramShown = true;
    bool m_open = false;
    Look m_look = Look::plain;
};

} // namespace teleta::study
