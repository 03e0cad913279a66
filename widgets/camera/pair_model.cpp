// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/pair_model.h"

#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/unit_title.h"

#include <array>

namespace teleta::camera {

namespace {

/// Decimals that distinguish neighbouring pairs; the same for a whole column.
QString pixelText(double value_px) {
    return base::fixedDigits(value_px, 1);
}

QString lengthText(double length_m) {
    return base::fixedDigits(1e3 * length_m, 2);
}

} // namespace

void PairModel::setPairs(const CalibratedPairs& pairs) {
    // Rows are added and removed at the end, so that a table keeps its scroll position while pairs are
    // collected.
    const int before = rowCount();
    const int after = static_cast<int>(pairs.pairs.size());
    if (after > before) {
        beginInsertRows({}, before, after - 1);
        m_pairs = pairs;
        endInsertRows();
    } else if (after < before) {
        beginRemoveRows({}, after, before - 1);
        m_pairs = pairs;
        endRemoveRows();
    } else {
        m_pairs = pairs;
    }
    tellChanged(0);
}

QString PairModel::text(std::size_t pair, int column) const {
    using State = CalibratedPairs::State;
    const vision::CalibrationPair& p = m_pairs.pairs[pair];
    const vision::PairResidual residual =
        m_pairs.residuals.empty() ? vision::PairResidual{} : m_pairs.residuals[pair];
    switch (column) {
    case number:
        return QString::number(pair + 1);
    case pixel:
        return QStringLiteral("%1, %2").arg(pixelText(p.pixel.x()), pixelText(p.pixel.y()));
    case point:
        return QStringLiteral("%1, %2, %3")
            .arg(lengthText(p.p_Sensor_m.x()), lengthText(p.p_Sensor_m.y()), lengthText(p.p_Sensor_m.z()));
    case imageError:
        return base::threeDigits(residual.error_px ? std::optional(residual.error_px->norm()) : std::nullopt)
            .trimmed();
    case surfaceError:
        return base::threeDigits(residual.error_m ? std::optional(1e3 * *residual.error_m) : std::nullopt)
            .trimmed();
    case condition: {
        static constexpr std::array kStates{"", QT_TR_NOOP("kept"), QT_TR_NOOP("wrong"),
                                            QT_TR_NOOP("excluded")};
        const State state = m_pairs.state(pair);
        return state == State::unknown ? QString() : tr(kStates[static_cast<std::size_t>(state)]);
    }
    default:
        return {};
    }
}

QVariant PairModel::sortValue(std::size_t pair, int column) const {
    const vision::PairResidual residual =
        m_pairs.residuals.empty() ? vision::PairResidual{} : m_pairs.residuals[pair];
    switch (column) {
    case number:
        return static_cast<int>(pair);
    case pixel:
        return m_pairs.pairs[pair].pixel.x();
    case point:
        return m_pairs.pairs[pair].p_Sensor_m.z();
    case imageError:
        return residual.error_px ? residual.error_px->norm() : -1.0;
    case surfaceError:
        return residual.error_m ? *residual.error_m : -1.0;
    default:
        return static_cast<int>(m_pairs.state(pair));
    }
}

QVariant PairModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const auto pair = static_cast<std::size_t>(index.row());
    if (role == Qt::CheckStateRole && index.column() == number)
        return m_pairs.used[pair] ? Qt::Checked : Qt::Unchecked;
    if (role == Qt::DisplayRole)
        return text(pair, index.column());
    if (role == kSortRole)
        return sortValue(pair, index.column());
    if (role == Qt::TextAlignmentRole && index.column() != condition)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QStringList PairModel::titles() const {
    return {tr("Pair"),
            base::titleWithUnit(tr("Pixel"), QStringLiteral("px")),
            base::titleWithUnit(tr("Point"), QStringLiteral("mm")),
            base::titleWithUnit(tr("Image"), QStringLiteral("px")),
            base::titleWithUnit(tr("Surface"), QStringLiteral("mm")),
            tr("State")};
}

Qt::ItemFlags PairModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == number ? flags | Qt::ItemIsUserCheckable : flags;
}

bool PairModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.column() != number || role != Qt::CheckStateRole)
        return false;
    emit useRequested(static_cast<std::size_t>(index.row()), value.toInt() == Qt::Checked);
    return true;
}

} // namespace teleta::camera
