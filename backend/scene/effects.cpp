// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/effects.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <utility>

namespace teleta::scene {

namespace {

struct EffectText {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

constexpr std::size_t kKinds = std::variant_size_v<EffectParameters>;

template <std::size_t... I>
constexpr std::array<EffectRow, kKinds> makeRows(std::index_sequence<I...>) {
    return {std::variant_alternative_t<I, EffectParameters>::kRow...};
}
constexpr std::array<EffectRow, kKinds> kRows = makeRows(std::make_index_sequence<kKinds>());

template <std::size_t... I>
EffectParameters makeParameters(std::size_t kind, std::index_sequence<I...>) {
    EffectParameters parameters;
    (void)((I == kind ? (parameters.emplace<I>(), true) : false) || ...);
    return parameters;
}

} // namespace

void DeadTaxelsSpec::describeKeys(Keys& keys, const core::ArrayLayout& layout) {
    keys.number("reading_N", reading_N, NumberRange::anyOrNan(), "What they read", Need::optional);
    keys.oneOf("count", "taxels", EffectText::tr("which taxels are dead is not clear").toStdString(),
               EffectText::tr("either \"count\" or \"taxels\"").toStdString());
    if (taxels.empty())
        keys.whole("count", count, {1, static_cast<long long>(layout.taxels()), "rows * columns"},
                   "How many are dead, drawn at random, instead of `taxels`", Need::optional);
    keys.tables(
        "taxels", taxels, 0, "Which taxels are dead",
        [layout](Keys& one, std::vector<TaxelIndex>& all, std::size_t i) {
            one.whole("row", all[i].row, {0, layout.rows - 1, "rows - 1"}, "Row of the taxel, from 0");
            one.whole("column", all[i].column, {0, layout.columns - 1, "columns - 1"},
                      "Column of the taxel, from 0");
        });
}

void HousingRimSpec::describeKeys(Keys& keys, const core::ArrayLayout& layout) {
    keys.number("stiffness_N_per_m", stiffness_NPerM, kPositive,
                "Stiffness of a piece of the rim that is as long as a pitch");
    keys.number("recess_m", recess_m, kNotNegative, "How far the rim lies below the surface of the array");
    keys.number("length_m", length_m, {.low = layout.columns * layout.pitchX_m, .lowIs = "columns * pitch_m"},
                "Length of the housing, along x");
    keys.number("width_m", width_m, {.low = layout.rows * layout.pitchY_m, .lowIs = "rows * pitch_m"},
                "Width of the housing, along y");
}

void LensDistortionSpec::describeKeys(Keys& keys) {
    constexpr std::array<std::string_view, 6> kRadial{"k1", "k2", "k3", "k4", "k5", "k6"};
    for (std::size_t i = 0; i < kRadial.size(); ++i)
        keys.number(kRadial[i], radial[i], kAny, "Radial coefficient of the rational model", Need::optional);
    constexpr std::array<std::string_view, 2> kTangential{"p1", "p2"};
    for (std::size_t i = 0; i < kTangential.size(); ++i)
        keys.number(kTangential[i], tangential[i], kAny, "Tangential coefficient of the rational model",
                    Need::optional);
}

const EffectRow& rowOf(const Effect& effect) {
    return kRows[effect.parameters.index()];
}

void describeEffect(Keys& keys, Effect& effect, const std::vector<ActsOn>& canHave,
                    const core::ArrayLayout& layout, std::span<const Effect> earlier) {
    std::vector<std::size_t> kinds;
    core::KeyNames names;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        if (std::ranges::find(canHave, kRows[kind].actsOn) == canHave.end())
            continue;
        kinds.push_back(kind);
        names.push_back({kRows[kind].name, kRows[kind].why});
    }
    const auto listed = std::ranges::find(kinds, effect.parameters.index());
    keys.choose(
        "name", static_cast<std::size_t>(listed - kinds.begin()), names, "Which effect", Need::required,
        [&](Keys& same, std::size_t chosen) {
            if (chosen >= kinds.size()) {
                const QString name = QString::fromUtf8(nameOf(effect).data());
                same.refuse(
                    "name",
                    EffectText::tr("this scene cannot have the effect \"%1\"").arg(name).toStdString(), {});
                return;
            }
            if (effect.parameters.index() != kinds[chosen])
                effect.parameters = makeParameters(kinds[chosen], std::make_index_sequence<kKinds>());
            if (std::ranges::any_of(earlier, [&](const Effect& other) {
                    return other.parameters.index() == effect.parameters.index();
                }))
                same.refuse("name", EffectText::tr("the effect is listed twice").toStdString(),
                            EffectText::tr("each effect at most once").toStdString());
            same.text("why", effect.why, "What the scene would lose without the effect");
            std::visit(
                [&](auto& spec) {
                    if constexpr (requires { spec.describeKeys(same, layout); })
                        spec.describeKeys(same, layout);
                    else
                        spec.describeKeys(same);
                },
                effect.parameters);
        });
}

} // namespace teleta::scene
