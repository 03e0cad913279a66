// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <QDialog>

class QTextBrowser;

namespace teleta::console {

/// A protocol to read, in words; nothing can be changed by accident. From here a study is made of it, or the
/// form is opened, in which a copy is changed. Thread: GUI.
class ProtocolReading : public QDialog {
    Q_OBJECT

public:
    explicit ProtocolReading(const study::Protocol& protocol, QWidget* parent = nullptr);

signals:
    void studyRequested(const teleta::study::Protocol& protocol);
    void changeRequested(const teleta::study::Protocol& protocol);

protected:
    void changeEvent(QEvent* event) override;

private:
    study::Protocol m_protocol;
    QTextBrowser* m_text;
};

} // namespace teleta::console
