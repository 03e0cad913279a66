// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/mat_file.h"

#include "backend/core/failure.h"
#include "backend/frames/arrays/array_libraries.h"
#include "backend/frames/arrays/mat_check.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdint>
#include <matio.h>
#include <utility>

namespace teleta::frames {

namespace {

struct MatFileText {
    Q_DECLARE_TR_FUNCTIONS(MatFileText)
};

constexpr std::size_t kMostVariables = 4096;

/// After openMat() has loaded them.
const MatioFunctions& matio() {
    return (*arrayLibraries())->matio;
}

struct FreeMatVariable {
    void operator()(matvar_t* variable) const { matio().freeVariable(variable); }
};
using MatVariable = std::unique_ptr<matvar_t, FreeMatVariable>;

/// Hands numbers of one type on, piece by piece. False: take ended it.
template <typename Number>
bool handOn(const void* data, std::size_t count, const ArrayFile::Take& take) {
    constexpr std::size_t kPiece = std::size_t{1} << 16U;
    const auto* numbers = static_cast<const Number*>(data);
    std::vector<double> piece;
    for (std::size_t done = 0; done < count; done += piece.size()) {
        piece.assign(numbers + done, numbers + std::min(done + kPiece, count));
        if (!take(piece))
            return false;
    }
    return true;
}

class MatFile : public ArrayFile {
public:
    explicit MatFile(const std::string& path)
        : ArrayFile(path) {}
    ~MatFile() override {
        if (m_file != nullptr)
            matio().close(m_file);
    }
    MatFile(const MatFile&) = delete;
    MatFile& operator=(const MatFile&) = delete;

    core::Expected<void> open() {
        m_file = matio().open(m_path.c_str(), MAT_ACC_RDONLY);
        if (m_file == nullptr)
            return damaged();
        const mat_ft version = matio().versionOf(m_file);
        if (version == MAT_FT_MAT5) {
            TELETA_CHECK(checkMat5(m_path));
        } else if (version == MAT_FT_MAT4) {
            TELETA_CHECK(checkMat4(m_path));
        }
        while (const MatVariable variable{matio().nextVariable(m_file)}) {
            if (m_arrays.size() == kMostVariables)
                return core::failed(core::ErrorKind::badInput,
                                    MatFileText::tr("the file has too many variables"),
                                    MatFileText::tr("at most %1").arg(kMostVariables), {m_path});
            if (variable->name == nullptr)
                continue;
            ArrayHead head{.name = variable->name, .isColumnMajor = true, .axisIsOpen = true};
            if (variable->dims != nullptr && variable->rank > 0 && variable->rank <= 32)
                head.shape.assign(variable->dims, variable->dims + variable->rank);
            head.problem = problemOf(*variable).toStdString();
            m_arrays.push_back(std::move(head));
        }
        return {};
    }

    core::Expected<void> read(std::size_t array, const Take& take) override {
        const ArrayHead& head = m_arrays[array];
        const MatVariable variable{matio().readVariable(m_file, head.name.c_str())};
        const std::uint64_t count = valuesOf(head.shape).value_or(0);
        if (!variable || (count > 0 && variable->data == nullptr) ||
            variable->nbytes < count * matio().sizeOf(variable->data_type))
            return damaged(head.name);
        if (!handOnValues(*variable, count, take))
            return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
        return {};
    }

private:
    [[nodiscard]] core::Unexpected damaged(const std::string& name = {}) const {
        return core::failed(core::ErrorKind::badInput, MatFileText::tr("the MAT file is damaged"),
                            MatFileText::tr("a whole MAT file of version 4, 5, 6, 7 or 7.3"),
                            {name.empty() ? m_path : m_path + ":" + name});
    }

    static QString problemOf(const matvar_t& variable) {
        if (variable.isComplex != 0)
            return MatFileText::tr("its values are complex");
        switch (variable.class_type) {
        case MAT_C_DOUBLE:
        case MAT_C_SINGLE:
        case MAT_C_INT8:
        case MAT_C_UINT8:
        case MAT_C_INT16:
        case MAT_C_UINT16:
        case MAT_C_INT32:
        case MAT_C_UINT32:
        case MAT_C_INT64:
        case MAT_C_UINT64:
            return {};
        case MAT_C_SPARSE:
            return MatFileText::tr("it is sparse");
        case MAT_C_CHAR:
            return MatFileText::tr("it contains text");
        case MAT_C_CELL:
        case MAT_C_STRUCT:
        case MAT_C_OBJECT:
            return MatFileText::tr("it contains other variables");
        default:
            return MatFileText::tr("its values are not real numbers");
        }
    }

    static bool handOnValues(const matvar_t& variable, std::size_t count, const Take& take) {
        switch (variable.data_type) {
        case MAT_T_DOUBLE:
            return handOn<double>(variable.data, count, take);
        case MAT_T_SINGLE:
            return handOn<float>(variable.data, count, take);
        case MAT_T_INT8:
            return handOn<std::int8_t>(variable.data, count, take);
        case MAT_T_UINT8:
            return handOn<std::uint8_t>(variable.data, count, take);
        case MAT_T_INT16:
            return handOn<std::int16_t>(variable.data, count, take);
        case MAT_T_UINT16:
            return handOn<std::uint16_t>(variable.data, count, take);
        case MAT_T_INT32:
            return handOn<std::int32_t>(variable.data, count, take);
        case MAT_T_UINT32:
            return handOn<std::uint32_t>(variable.data, count, take);
        case MAT_T_INT64:
            return handOn<std::int64_t>(variable.data, count, take);
        case MAT_T_UINT64:
            return handOn<std::uint64_t>(variable.data, count, take);
        default:
            return true; // no values: framesOf() tells how many are missing
        }
    }

    mat_t* m_file = nullptr;
};

} // namespace

core::Expected<std::unique_ptr<ArrayFile>> openMat(const std::string& path) {
    TELETA_CHECK(arrayLibraries());
    auto file = std::make_unique<MatFile>(path);
    TELETA_CHECK(file->open());
    return file;
}

} // namespace teleta::frames
