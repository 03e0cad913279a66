// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QByteArray>
#include <QObject>
#include <QSizeF>
#include <QString>

#include <functional>

class QMenu;
class QPainter;
class QWidget;

namespace teleta::base {

/// A picture with the data behind it; it owns both, so the view may change meanwhile. paint draws on white,
/// for paper, into a rectangle of size_px at the origin.
struct Figure {
    QString name;                         ///< file name without extension
    QSizeF size_px;                       ///< at 96 dots per inch
    std::function<void(QPainter&)> paint; ///< vectors wherever possible
    std::function<QString()> csv;         ///< header line and rows, C locale; empty when there are no data
    QByteArray svg = {};                  ///< complete SVG of the same picture; empty: made by paint
};

/// Writes a figure in the format of the extension: svg, pdf, png (at 192 dots per inch, twice the resolution
/// of the screen) or csv. The file is written under another name and then renamed, so it is never incomplete.
/// Error: badInput for another extension; ioFailed with the path.
[[nodiscard]] core::Expected<void> saveFigure(const Figure& figure, const QString& path);

/// Puts the picture (PNG and SVG) or the data (text and CSV) on the clipboard.
void copyPicture(const Figure& figure);
void copyData(const Figure& figure);

/// The actions of every chart and matrix. They return at once; a signal tells whether saving worked.
/// Thread: GUI.
class FigureExport : public QObject {
    Q_OBJECT
public:
    /// make: called whenever an action is triggered.
    FigureExport(QWidget* view, std::function<Figure()> make);

    /// Appends Copy Picture, Copy Data, Save Picture, Save Data.
    void addActions(QMenu& menu);
    /// Makes these actions the view's context menu.
    void setContextMenu();
    /// Only Copy Picture and Save Picture, for data of any size.
    void addPictureActions(QMenu& menu);
    /// Only Copy Data and Save Data, for tables.
    void addDataActions(QMenu& menu);

signals:
    void saved(const QString& path);
    void failed(const QString& message);

private:
    void askAndSave(bool picture);

    QWidget* m_view;
    std::function<Figure()> m_make;
};

} // namespace teleta::base
