// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/titled_model.h"
#include "widgets/camera/residual_picture.h"

namespace teleta::camera {

/// Pairs of a calibration as a table; the check box in the first column says whether a pair is used. Checking
/// it emits a request and changes nothing here. Thread: GUI.
class PairModel : public base::TitledModel {
    Q_OBJECT
public:
    enum Column { number, pixel, point, imageError, surfaceError, condition };
    static constexpr int kColumns = 6;
    /// Sort key of a cell.
    static constexpr int kSortRole = Qt::UserRole;

    explicit PairModel(QObject* parent = nullptr)
        : TitledModel(kColumns, parent) {}

    void setPairs(const CalibratedPairs& pairs);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    void useRequested(std::size_t pair, bool use);

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_pairs.pairs.size()); }
    [[nodiscard]] QStringList titles() const override;
    [[nodiscard]] QString text(std::size_t pair, int column) const;
    [[nodiscard]] QVariant sortValue(std::size_t pair, int column) const;

    CalibratedPairs m_pairs;
};

} // namespace teleta::camera
