// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/figure/drawing_part.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <cairo-pdf.h>
#include <cairo.h>
#include <cmath>
#include <librsvg/rsvg.h>
#include <memory>

namespace teleta::figure {

namespace {

struct FigureText {
    Q_DECLARE_TR_FUNCTIONS(FigureText)
};

constexpr double kPointsPerPx = 72.0 / 96.0;
constexpr double kMostPixels = 32'767.0; // of cairo

struct HandleCloser {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
};
struct SurfaceCloser {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ContextCloser {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Handle = std::unique_ptr<RsvgHandle, HandleCloser>;
using Surface = std::unique_ptr<cairo_surface_t, SurfaceCloser>;
using Context = std::unique_ptr<cairo_t, ContextCloser>;

core::Unexpected failed(core::ErrorKind kind, GError* error) {
    const QString message = error == nullptr ? QString() : QString::fromUtf8(error->message);
    g_clear_error(&error);
    return core::failed(kind, FigureText::tr("cannot draw the picture: %1").arg(message));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

struct Picture {
    Handle handle;
    double width = 0.0;
    double height = 0.0;
};

core::Expected<Picture> read(const std::string& svg) {
    GError* error = nullptr;
    Picture picture;
    picture.handle.reset(
        rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    if (picture.handle == nullptr)
        return failed(core::ErrorKind::badInput, error);
    const gboolean hasSize =
        rsvg_handle_get_intrinsic_size_in_pixels(picture.handle.get(), &picture.width, &picture.height);
    if (hasSize == FALSE || !(picture.width > 0.0 && picture.height > 0.0))
        return core::failed(core::ErrorKind::badInput, FigureText::tr("the picture has no size"));
    return picture;
}

core::Expected<void> draw(const Picture& picture, cairo_surface_t* surface, double scale) {
    const Context context(cairo_create(surface));
    const RsvgRectangle page{0.0, 0.0, picture.width * scale, picture.height * scale};
    GError* error = nullptr;
    if (rsvg_handle_render_document(picture.handle.get(), context.get(), &page, &error) == FALSE)
        return failed(core::ErrorKind::ioFailed, error);
    cairo_show_page(context.get());
    if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS)
        return core::failed(core::ErrorKind::ioFailed,
                            QString::fromUtf8(cairo_status_to_string(cairo_status(context.get()))));
    return {};
}

core::Expected<std::string> pdfOf(const std::string& svg) {
    TELETA_TRY(const Picture picture, read(svg));
    std::string pdf;
    {
        const Surface surface(cairo_pdf_surface_create_for_stream(append, &pdf, picture.width * kPointsPerPx,
                                                                  picture.height * kPointsPerPx));
        TELETA_CHECK(draw(picture, surface.get(), kPointsPerPx));
        cairo_surface_finish(surface.get());
        if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
            return core::failed(core::ErrorKind::ioFailed, QString::fromUtf8(cairo_status_to_string(
                                                               cairo_surface_status(surface.get()))));
    }
    return pdf;
}

core::Expected<std::string> pngOf(const std::string& svg, double scale) {
    TELETA_TRY(const Picture picture, read(svg));
    const double width = std::ceil(picture.width * scale);
    const double height = std::ceil(picture.height * scale);
    if (!(width >= 1.0 && height >= 1.0 && width <= kMostPixels && height <= kMostPixels))
        return core::failed(core::ErrorKind::badInput,
                            FigureText::tr("the picture would have too many pixels"));
    const Surface surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(width), static_cast<int>(height)));
    TELETA_CHECK(draw(picture, surface.get(), scale));
    std::string png;
    const cairo_status_t written = cairo_surface_write_to_png_stream(surface.get(), append, &png);
    if (written != CAIRO_STATUS_SUCCESS)
        return core::failed(core::ErrorKind::ioFailed, QString::fromUtf8(cairo_status_to_string(written)));
    return png;
}

} // namespace

} // namespace teleta::figure

const teleta::figure::Drawing teleta_drawing{teleta::figure::pdfOf, teleta::figure::pngOf};
