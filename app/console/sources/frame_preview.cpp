// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/frame_preview.h"

#include "app/console/sources/known_array.h"
#include "backend/frames/frame_reader.h"
#include "widgets/base/background.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/compose.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/theme.h"

#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QRegularExpression>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

constexpr std::chrono::milliseconds kWait{250};
constexpr QSize kPicture_em(22, 11);

QString numberText(double value) {
    return QLocale().toString(value, 'g', 4).replace(QLatin1Char('-'), QChar(0x2212));
}

} // namespace

QString withoutOptions(QString problem) {
    static const QRegularExpression inBrackets(
        QStringLiteral(R"( ?[(\x{FF08}]--(?:[^()\x{FF08}\x{FF09}]|\([^()]*\))*[)\x{FF09}])"));
    return problem.remove(inBrackets);
}

/// One frame, a square for each taxel.
class FramePreview::Picture : public QWidget {
public:
    explicit Picture(QWidget* parent)
        : QWidget(parent) {
        setObjectName(QStringLiteral("framePicture"));
        setMinimumSize(base::em(this, kPicture_em.width()), base::em(this, kPicture_em.height()));
    }

    void setImage(QImage image) {
        m_image = std::move(image);
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        if (m_image.isNull())
            return;
        const QSize size = m_image.size().scaled(this->size(), Qt::KeepAspectRatio);
        painter.drawImage(QRect(QPoint((width() - size.width()) / 2, (height() - size.height()) / 2), size),
                          m_image);
    }

private:
    QImage m_image;
};

FramePreview::FramePreview(const QString& known, QWidget* parent)
    : QWidget(parent)
    , m_known(known)
    , m_picture(new Picture(this))
    , m_slider(new QSlider(Qt::Horizontal))
    , m_place(new QLabel)
    , m_about(new QLabel)
    , m_problem(new QLabel) {
    m_slider->setObjectName(QStringLiteral("frame"));
    m_slider->setAccessibleName(tr("Frame"));
    m_slider->setToolTip(tr("Choose a frame"));
    m_about->setObjectName(QStringLiteral("about"));
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setWordWrap(true);
    m_problem->setTextInteractionFlags(Qt::TextSelectableByMouse);
    base::setTextColour(m_problem, base::statusColours(palette()).lost);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_picture, 1);
    layout->addWidget(m_slider);
    layout->addWidget(m_place);
    layout->addWidget(m_about);
    layout->addWidget(m_problem);
    m_wait.setSingleShot(true);
    connect(&m_wait, &QTimer::timeout, this, &FramePreview::read);
    connect(m_slider, &QSlider::valueChanged, this, &FramePreview::showFrame);
    showContent({});
    m_about->clear();
}

FramePreview::~FramePreview() {
    if (m_ended)
        m_ended->store(true);
}

void FramePreview::setRequest(const frames::FrameRequest& request) {
    m_request = request;
    m_wait.start(kWait);
}

FramePreview::Content FramePreview::contentOf(frames::FrameRequest request, const std::atomic<bool>& ended) {
    const auto goOn = [&] { return !ended.load(); };
    Content content;
    auto known = withKnownArray(std::move(request));
    if (!known) {
        content.problem = core::describe(known.error());
        return content;
    }
    request = *std::move(known);
    auto reader = frames::FrameReader::open(request, goOn);
    if (!reader) {
        core::Error problem = reader.error();
        problem.where.file = QFileInfo(QString::fromStdString(request.path)).fileName().toStdString();
        content.problem = core::describe(problem);
        // Where only the times are missing, the frames can be seen.
        request.needsTimes = false;
        reader = frames::FrameReader::open(request, goOn);
        if (!reader)
            return content;
    }
    const core::TaxelLayout& taxels = reader->taxels();
    content.layout = taxels.grid();
    content.unit = reader->unit();
    std::vector<float> frame(taxels.values());
    double time_s = 0.0;
    while (goOn()) {
        const auto isThere = reader->next(time_s, frame);
        if (!isThere)
            content.problem = core::describe(isThere.error());
        if (!isThere || !*isThere)
            break;
        if (content.time_s.size() == kFrames) {
            content.isAll = false;
            break;
        }
        content.time_s.push_back(time_s);
        if (!taxels.isVector())
            content.values.insert(content.values.end(), frame.begin(), frame.end());
        // What presses has a negative z.
        for (std::size_t z = 2; taxels.isVector() && z < frame.size(); z += core::TaxelLayout::kVector)
            content.values.push_back(-frame[z]);
    }
    for (const float value : content.values)
        if (std::isfinite(value)) {
            content.lowest = std::fmin(content.lowest, value);
            content.highest = std::fmax(content.highest, value);
        }
    return content;
}

void FramePreview::read() {
    if (m_ended)
        m_ended->store(true);
    m_ended = std::make_shared<std::atomic<bool>>(false);
    m_about->setText(tr("Reading\u2026"));
    base::runInBackground(
        this, [request = m_request, ended = m_ended] { return contentOf(request, *ended); },
        [this, ended = m_ended](Content content) {
            if (!ended->load())
                showContent(std::move(content));
        });
}

void FramePreview::showContent(Content content) {
    m_content = std::move(content);
    const auto frames = static_cast<int>(m_content.time_s.size());
    m_slider->setRange(0, std::max(0, frames - 1));
    m_slider->setVisible(frames > 1);
    const QString problem = QString::fromStdString(m_content.problem);
    m_problem->setText(withoutOptions(problem));
    m_problem->setVisible(!problem.isEmpty() && problem != m_known);
    if (frames == 0) {
        m_about->setText(tr("No frame to show."));
    } else {
        const QString unit = QString::fromStdString(m_content.unit);
        const auto value = [&](float number) {
            return unit.isEmpty() ? numberText(number) : base::withUnit(numberText(number), unit);
        };
        //: Numbers of rows and columns, lowest and highest value
        m_about->setText((m_content.isAll
                              ? tr("%n frame(s) of %1 \u00d7 %2 taxels, %3 to %4", nullptr, frames)
                              : tr("The first %n frame(s) of %1 \u00d7 %2 taxels, %3 to %4", nullptr, frames))
                             .arg(m_content.layout.rows)
                             .arg(m_content.layout.columns)
                             .arg(value(m_content.lowest), value(m_content.highest)));
    }
    showFrame();
}

void FramePreview::showFrame() {
    const auto frame = static_cast<std::size_t>(m_slider->value());
    if (frame >= m_content.time_s.size()) {
        m_place->clear();
        m_picture->setImage({});
        return;
    }
    const core::ArrayLayout& layout = m_content.layout;
    QImage image(layout.columns, layout.rows, QImage::Format_RGB32);
    const float range = m_content.highest - m_content.lowest;
    const float* value = &m_content.values[frame * layout.taxels()];
    for (int row = 0; row < layout.rows; ++row)
        for (int column = 0; column < layout.columns; ++column, ++value)
            image.setPixel(column, row,
                           std::isfinite(*value)
                               ? base::colourAt(base::cividis(),
                                                range > 0.0F ? (*value - m_content.lowest) / range : 0.0F)
                               : palette().color(QPalette::Mid).rgb());
    m_picture->setImage(std::move(image));
    m_place->setText(tr("Frame %1 of %2, %3 s")
                         .arg(frame + 1)
                         .arg(m_content.time_s.size())
                         .arg(QLocale().toString(m_content.time_s[frame], 'f', 3)));
}

} // namespace teleta::console
