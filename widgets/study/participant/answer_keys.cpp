// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/participant/answer_keys.h"

#include <QGuiApplication>
#include <QKeyEvent>

#include <array>

namespace teleta::study {

namespace {

using Kind = PhysicalKey::Kind;

constexpr quint32 kDigit1 = 10;
constexpr quint32 kDigit9 = 18;
constexpr quint32 kSpace = 65;
constexpr std::array<quint32, 9> kPad{87, 88, 89, 83, 84, 85, 79, 80, 81}; ///< 1 .. 9

struct LetterKey {
    char letter;
    quint32 code;
    Qt::Key key;
};
constexpr std::array<LetterKey, 4> kLetters{
    {{'Y', 29, Qt::Key_Y}, {'N', 57, Qt::Key_N}, {'S', 39, Qt::Key_S}, {'D', 40, Qt::Key_D}}};

bool hasEvdevCodes() {
    static const bool has = QGuiApplication::platformName() == QLatin1String("xcb") ||
                            QGuiApplication::platformName().startsWith(QLatin1String("wayland"));
    return has;
}

std::optional<PhysicalKey> byScanCode(quint32 code) {
    if (code >= kDigit1 && code <= kDigit9)
        return PhysicalKey{Kind::digit, code - kDigit1 + 1};
    if (code == kSpace)
        return PhysicalKey{Kind::space, 0};
    for (std::size_t i = 0; i < kPad.size(); ++i) {
        if (kPad[i] == code)
            return PhysicalKey{Kind::pad, i + 1};
    }
    for (const LetterKey& one : kLetters) {
        if (one.code == code)
            return PhysicalKey{Kind::letter, 0, one.letter};
    }
    return std::nullopt;
}

} // namespace

QString PhysicalKey::code() const {
    return kind == Kind::digit    ? QStringLiteral("Digit%1").arg(number)
           : kind == Kind::pad    ? QStringLiteral("Numpad%1").arg(number)
           : kind == Kind::letter ? QStringLiteral("Key%1").arg(QLatin1Char(letter))
                                  : QStringLiteral("Space");
}

QString PhysicalKey::device() const {
    return kind == Kind::pad ? QStringLiteral("keypad") : QStringLiteral("keyboard");
}

std::optional<PhysicalKey> physicalKey(const QKeyEvent& event) {
    if (hasEvdevCodes() && event.nativeScanCode() != 0)
        return byScanCode(event.nativeScanCode());
    if (event.key() == Qt::Key_Space)
        return PhysicalKey{Kind::space, 0};
    for (const LetterKey& one : kLetters) {
        if (event.key() == one.key)
            return PhysicalKey{Kind::letter, 0, one.letter};
    }
    if (event.key() < Qt::Key_1 || event.key() > Qt::Key_9)
        return std::nullopt;
    return PhysicalKey{event.modifiers().testFlag(Qt::KeypadModifier) ? Kind::pad : Kind::digit,
                       static_cast<std::size_t>(event.key() - Qt::Key_1) + 1};
}

} // namespace teleta::study
