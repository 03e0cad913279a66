// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/hdf5_file.h"

#include "backend/core/failure.h"
#include "backend/frames/arrays/array_libraries.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cstring>
#include <hdf5.h>
#include <stdlib.h>
#include <string_view>
#include <utility>

namespace teleta::frames {

namespace {

struct Hdf5FileText {
    Q_DECLARE_TR_FUNCTIONS(Hdf5FileText)
};

constexpr std::size_t kMostDatasets = 4096;
constexpr std::uint64_t kPieceValues = std::uint64_t{2} << 20U; ///< 16 MB
constexpr std::size_t kChunkCache_bytes = std::size_t{64} << 20U;

/// After openHdf5() has loaded them.
const Hdf5Functions& hdf5() {
    return (*arrayLibraries())->hdf5;
}

/// An identifier of the library, closed with the object.
class Handle {
public:
    using Close = herr_t (*)(hid_t);
    Handle(hid_t id, Close close)
        : m_id(id)
        , m_close(close) {}
    ~Handle() {
        if (m_id >= 0)
            m_close(m_id);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] hid_t id() const { return m_id; }
    [[nodiscard]] bool isValid() const { return m_id >= 0; }

private:
    hid_t m_id;
    Close m_close;
};

/// What the library says went wrong: the place where it noticed.
QString libraryReason() {
    std::string reason;
    hdf5().walkErrors(
        0, H5E_WALK_UPWARD,
        [](unsigned number, const H5E_error2_t* error, void* text) -> herr_t {
            if (number == 0 && error->desc != nullptr)
                *static_cast<std::string*>(text) = error->desc;
            return 0;
        },
        &reason);
    return QString::fromStdString(reason.empty() ? "?" : reason);
}

class Hdf5File : public ArrayFile {
public:
    explicit Hdf5File(const std::string& path)
        : ArrayFile(path) {}
    ~Hdf5File() override {
        if (m_file >= 0)
            hdf5().closeFile(m_file);
    }
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    core::Expected<void> open() {
        hdf5().open();
        hdf5().setErrorHandler(0, nullptr, nullptr);
        m_file = hdf5().openFile(m_path.c_str(), 0, 0);
        if (m_file < 0)
            return damaged();
        std::vector<std::string> names;
        const herr_t visited = hdf5().visit(
            m_file, H5_INDEX_NAME, H5_ITER_INC,
            [](hid_t, const char* name, const H5O_info_t* info, void* to) -> herr_t {
                auto& list = *static_cast<std::vector<std::string>*>(to);
                if (info->type == H5O_TYPE_DATASET)
                    list.emplace_back(name);
                return list.size() > kMostDatasets ? 1 : 0;
            },
            &names, H5O_INFO_BASIC);
        if (visited < 0)
            return damaged();
        if (names.size() > kMostDatasets)
            return core::failed(core::ErrorKind::badInput, Hdf5FileText::tr("the file has too many datasets"),
                                Hdf5FileText::tr("at most %1").arg(kMostDatasets), {m_path});
        for (std::string& name : names) {
            TELETA_TRY(ArrayHead head, headOf(std::move(name)));
            m_arrays.push_back(std::move(head));
        }
        return {};
    }

    core::Expected<void> read(std::size_t array, const Take& take) override {
        const ArrayHead& head = m_arrays[array];
        const Handle access(hdf5().createProperties(*hdf5().datasetAccess), hdf5().closeProperties);
        hdf5().setChunkCache(access.id(), 12'421, kChunkCache_bytes, 0.75);
        const Handle dataset(hdf5().openDataset(m_file, head.name.c_str(), access.id()), hdf5().closeDataset);
        const Handle space(dataset.isValid() ? hdf5().spaceOf(dataset.id()) : -1, hdf5().closeSpace);
        if (!space.isValid())
            return damaged(head.name);
        const std::uint64_t count = valuesOf(head.shape).value_or(0);
        std::vector<double> values(std::min(count, kPieceValues));
        if (head.shape.empty()) {
            if (hdf5().read(dataset.id(), *hdf5().doubles, 0, 0, 0, values.data()) < 0)
                return damaged(head.name);
            return take(values) ? core::Expected<void>() : core::Unexpected(cancelled());
        }
        for (std::uint64_t done = 0; done < count;) {
            const Piece piece = pieceAt(head.shape, done);
            const auto one = static_cast<hsize_t>(piece.values);
            const Handle memory(hdf5().createSpace(1, &one, nullptr), hdf5().closeSpace);
            if (hdf5().select(space.id(), H5S_SELECT_SET, piece.start.data(), nullptr, piece.sides.data(),
                              nullptr) < 0 ||
                hdf5().read(dataset.id(), *hdf5().doubles, memory.id(), space.id(), 0, values.data()) < 0)
                return damaged(head.name);
            if (!take(std::span(values).first(piece.values)))
                return core::Unexpected(cancelled());
            done += piece.values;
        }
        return {};
    }

private:
    /// Values that lie side by side in the order of the file.
    struct Piece {
        std::array<hsize_t, H5S_MAX_RANK> start{};
        std::array<hsize_t, H5S_MAX_RANK> sides{};
        std::uint64_t values = 1;
    };

    /// The piece that starts at a value, of at most kPieceValues.
    static Piece pieceAt(std::span<const std::uint64_t> shape, std::uint64_t done) {
        Piece piece;
        std::uint64_t inner = 1;
        bool isWhole = true; // the dimensions so far are taken as a whole
        for (std::size_t i = shape.size(); i-- > 0;) {
            piece.start[i] = done / inner % shape[i];
            piece.sides[i] = 1;
            if (isWhole) {
                const std::uint64_t fits = std::max<std::uint64_t>(kPieceValues / inner, 1);
                piece.sides[i] = std::min<std::uint64_t>(shape[i] - piece.start[i], fits);
                isWhole = piece.sides[i] == shape[i];
            }
            piece.values *= piece.sides[i];
            inner *= shape[i];
        }
        return piece;
    }

    static core::Error cancelled() { return {core::ErrorKind::cancelled, {}, {}, {}}; }

    [[nodiscard]] core::Unexpected damaged(const std::string& name = {}) const {
        return core::failed(
            core::ErrorKind::badInput, Hdf5FileText::tr("the HDF5 file is damaged: %1").arg(libraryReason()),
            Hdf5FileText::tr("a whole HDF5 file"), {name.empty() ? m_path : m_path + ":/" + name});
    }

    core::Expected<ArrayHead> headOf(std::string name) const {
        ArrayHead head{.name = std::move(name)};
        const Handle dataset(hdf5().openDataset(m_file, head.name.c_str(), 0), hdf5().closeDataset);
        const Handle space(dataset.isValid() ? hdf5().spaceOf(dataset.id()) : -1, hdf5().closeSpace);
        const Handle type(dataset.isValid() ? hdf5().typeOf(dataset.id()) : -1, hdf5().closeType);
        const Handle creation(dataset.isValid() ? hdf5().creationOf(dataset.id()) : -1,
                              hdf5().closeProperties);
        if (!space.isValid() || !type.isValid() || !creation.isValid()) {
            head.problem = Hdf5FileText::tr("it is damaged: %1").arg(libraryReason()).toStdString();
            return head;
        }
        const int dimensions = hdf5().dimensionsOf(space.id());
        if (dimensions > 0 && dimensions <= H5S_MAX_RANK) {
            std::array<hsize_t, H5S_MAX_RANK> sides{};
            hdf5().sidesOf(space.id(), sides.data(), nullptr);
            head.shape.assign(sides.begin(), sides.begin() + dimensions);
        }
        head.problem = problemOf(dataset.id(), space.id(), type.id(), creation.id(), head).toStdString();
        head.unit = textAttribute(dataset.id(), "unit");
        head.rate_Hz = numberAttribute(dataset.id(), "rate_hz");
        head.pitch_m = numberAttribute(dataset.id(), "pitch_m");
        return head;
    }

    /// Why a dataset is not read; empty: it is.
    static QString problemOf(hid_t dataset, hid_t space, hid_t type, hid_t creation, const ArrayHead& head) {
        if (hdf5().extentOf(space) == H5S_NULL)
            return Hdf5FileText::tr("it has no values");
        const H5T_class_t kind = hdf5().classOf(type);
        if (kind != H5T_INTEGER && kind != H5T_FLOAT)
            return kind == H5T_STRING     ? Hdf5FileText::tr("it contains text")
                   : kind == H5T_COMPOUND ? Hdf5FileText::tr("its values are compound")
                                          : Hdf5FileText::tr("its values are not real numbers");
        if (hdf5().externalOf(creation) > 0 || hdf5().layoutOf(creation) == H5D_VIRTUAL)
            return Hdf5FileText::tr("its values are stored in other files");
        for (int i = 0; i < hdf5().filtersOf(creation); ++i) {
            unsigned flags = 0;
            unsigned settings = 0;
            std::size_t settingCount = 0;
            std::array<char, 64> name{};
            const H5Z_filter_t filter =
                hdf5().filterOf(creation, static_cast<unsigned>(i), &flags, &settingCount, nullptr,
                                name.size() - 1, name.data(), &settings);
            if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE &&
                filter != H5Z_FILTER_FLETCHER32)
                return Hdf5FileText::tr("it is compressed with %1; only gzip and shuffle can be read")
                    .arg(name[0] == '\0' ? QString::number(filter) : QString::fromUtf8(name.data()));
        }
        // What was never written reads as zeros: a file of 2 kB may have 2^31 of them. gzip packs a
        // thousandfold at most.
        constexpr std::uint64_t kMostPacked = 4096;
        if (const std::uint64_t count = valuesOf(head.shape).value_or(0);
            count > 0 && hdf5().storageOf(dataset) <= count * hdf5().sizeOf(type) / kMostPacked)
            return Hdf5FileText::tr("its values were never written");
        return {};
    }

    static std::optional<double> numberAttribute(hid_t dataset, const char* name) {
        if (hdf5().hasAttribute(dataset, name) <= 0)
            return std::nullopt;
        const Handle attribute(hdf5().openAttribute(dataset, name, 0), hdf5().closeAttribute);
        if (!isSingle(attribute))
            return std::nullopt;
        const Handle type(hdf5().attributeType(attribute.id()), hdf5().closeType);
        const H5T_class_t kind = hdf5().classOf(type.id());
        double value = 0.0;
        if ((kind != H5T_INTEGER && kind != H5T_FLOAT) ||
            hdf5().readAttribute(attribute.id(), *hdf5().doubles, &value) < 0)
            return std::nullopt;
        return value;
    }

    static std::string textAttribute(hid_t dataset, const char* name) {
        if (hdf5().hasAttribute(dataset, name) <= 0)
            return {};
        const Handle attribute(hdf5().openAttribute(dataset, name, 0), hdf5().closeAttribute);
        if (!isSingle(attribute))
            return {};
        const Handle type(hdf5().attributeType(attribute.id()), hdf5().closeType);
        if (hdf5().classOf(type.id()) != H5T_STRING)
            return {};
        constexpr std::size_t kMostText = 256;
        std::string text;
        if (hdf5().isVariableText(type.id()) > 0) {
            char* pointer = nullptr;
            if (hdf5().readAttribute(attribute.id(), type.id(), &pointer) < 0 || pointer == nullptr)
                return {};
            text.assign(pointer, strnlen(pointer, kMostText));
            hdf5().freeMemory(pointer);
        } else if (const std::size_t size = hdf5().sizeOf(type.id()); size <= kMostText) {
            std::array<char, kMostText + 1> buffer{};
            if (hdf5().readAttribute(attribute.id(), type.id(), buffer.data()) < 0)
                return {};
            text = buffer.data();
        }
        return text;
    }

    static bool isSingle(const Handle& attribute) {
        const Handle space(attribute.isValid() ? hdf5().attributeSpace(attribute.id()) : -1,
                           hdf5().closeSpace);
        if (!space.isValid())
            return false;
        const int dimensions = hdf5().dimensionsOf(space.id());
        hsize_t side = 1;
        if (dimensions == 1)
            hdf5().sidesOf(space.id(), &side, nullptr);
        return hdf5().extentOf(space.id()) != H5S_NULL && (dimensions == 0 || dimensions == 1) && side == 1;
    }

    hid_t m_file = -1;
};

} // namespace

core::Expected<std::unique_ptr<ArrayFile>> openHdf5(const std::string& path) {
    // Files on disks without locks are read too, and no filter is loaded from elsewhere.
    ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
    ::setenv("HDF5_PLUGIN_PRELOAD", "::", 1);
    TELETA_CHECK(arrayLibraries());
    auto file = std::make_unique<Hdf5File>(path);
    TELETA_CHECK(file->open());
    return file;
}

} // namespace teleta::frames
