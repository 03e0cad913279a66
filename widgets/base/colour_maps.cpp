// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/colour_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace teleta::base {

namespace {

// clang-format off
constexpr std::array<std::uint32_t, kMapEntries> kCividis{
    0x00224e, 0x00234f, 0x002451, 0x002553, 0x002554, 0x002656, 0x002758, 0x002859,
    0x00285b, 0x00295d, 0x002a5f, 0x002a61, 0x002b62, 0x002c64, 0x002c66, 0x002d68,
    0x002e6a, 0x002e6c, 0x002f6d, 0x00306f, 0x003070, 0x003170, 0x003171, 0x013271,
    0x053371, 0x083370, 0x0c3470, 0x0f3570, 0x123570, 0x143670, 0x163770, 0x18376f,
    0x1a386f, 0x1c396f, 0x1e3a6f, 0x203a6f, 0x213b6e, 0x233c6e, 0x243c6e, 0x263d6e,
    0x273e6e, 0x293f6e, 0x2a3f6d, 0x2b406d, 0x2d416d, 0x2e416d, 0x2f426d, 0x31436d,
    0x32436d, 0x33446d, 0x34456c, 0x35456c, 0x36466c, 0x38476c, 0x39486c, 0x3a486c,
    0x3b496c, 0x3c4a6c, 0x3d4a6c, 0x3e4b6c, 0x3f4c6c, 0x404c6c, 0x414d6c, 0x424e6c,
    0x434e6c, 0x444f6c, 0x45506c, 0x46516c, 0x47516c, 0x48526c, 0x49536c, 0x4a536c,
    0x4b546c, 0x4c556c, 0x4d556c, 0x4e566c, 0x4f576c, 0x50576c, 0x51586d, 0x52596d,
    0x535a6d, 0x545a6d, 0x555b6d, 0x555c6d, 0x565c6d, 0x575d6d, 0x585e6d, 0x595e6e,
    0x5a5f6e, 0x5b606e, 0x5c616e, 0x5d616e, 0x5e626e, 0x5e636f, 0x5f636f, 0x60646f,
    0x61656f, 0x62656f, 0x636670, 0x646770, 0x656870, 0x656870, 0x666970, 0x676a71,
    0x686a71, 0x696b71, 0x6a6c71, 0x6b6d72, 0x6c6d72, 0x6c6e72, 0x6d6f72, 0x6e6f73,
    0x6f7073, 0x707173, 0x717274, 0x727274, 0x727374, 0x737475, 0x747475, 0x757575,
    0x767676, 0x777776, 0x777777, 0x787877, 0x797977, 0x7a7a78, 0x7b7a78, 0x7c7b78,
    0x7d7c78, 0x7e7c78, 0x7e7d78, 0x7f7e78, 0x807f78, 0x817f78, 0x828079, 0x838179,
    0x848279, 0x858279, 0x868379, 0x878478, 0x888578, 0x898578, 0x8a8678, 0x8b8778,
    0x8c8878, 0x8d8878, 0x8e8978, 0x8f8a78, 0x908b78, 0x918b78, 0x928c78, 0x928d78,
    0x938e78, 0x948e77, 0x958f77, 0x969077, 0x979177, 0x989277, 0x999277, 0x9a9376,
    0x9b9476, 0x9c9576, 0x9d9576, 0x9e9676, 0x9f9775, 0xa09875, 0xa19975, 0xa29975,
    0xa39a74, 0xa49b74, 0xa59c74, 0xa69c74, 0xa79d73, 0xa89e73, 0xa99f73, 0xaaa073,
    0xaba072, 0xaca172, 0xada272, 0xaea371, 0xafa471, 0xb0a571, 0xb1a570, 0xb3a670,
    0xb4a76f, 0xb5a86f, 0xb6a96f, 0xb7a96e, 0xb8aa6e, 0xb9ab6d, 0xbaac6d, 0xbbad6d,
    0xbcae6c, 0xbdae6c, 0xbeaf6b, 0xbfb06b, 0xc0b16a, 0xc1b26a, 0xc2b369, 0xc3b369,
    0xc4b468, 0xc5b568, 0xc6b667, 0xc7b767, 0xc8b866, 0xc9b965, 0xcbb965, 0xccba64,
    0xcdbb63, 0xcebc63, 0xcfbd62, 0xd0be62, 0xd1bf61, 0xd2c060, 0xd3c05f, 0xd4c15f,
    0xd5c25e, 0xd6c35d, 0xd7c45c, 0xd9c55c, 0xdac65b, 0xdbc75a, 0xdcc859, 0xddc858,
    0xdec958, 0xdfca57, 0xe0cb56, 0xe1cc55, 0xe2cd54, 0xe4ce53, 0xe5cf52, 0xe6d051,
    0xe7d150, 0xe8d24f, 0xe9d34e, 0xead34c, 0xebd44b, 0xedd54a, 0xeed649, 0xefd748,
    0xf0d846, 0xf1d945, 0xf2da44, 0xf3db42, 0xf5dc41, 0xf6dd3f, 0xf7de3e, 0xf8df3c,
    0xf9e03a, 0xfbe138, 0xfce236, 0xfde334, 0xfee434, 0xfee535, 0xfee636, 0xfee838,
};
// clang-format on

constexpr std::array<QRgb, kIdentityColours> kIdentityOnLight{0xff265ba3, 0xffae4500, 0xff008a56, 0xffb54d88,
                                                              0xffbd8a12, 0xff369dd8, 0xff673400, 0xff46433f};
constexpr std::array<QRgb, kIdentityColours> kIdentityOnDark{0xff56b4e9, 0xffe69f00, 0xff37df86, 0xffcc79a7,
                                                             0xfff0e442, 0xff5a7fe8, 0xffe4593a, 0xffe4e4e4};

constexpr double kWhiteX = 0.95047, kWhiteZ = 1.08883; // D65, Y = 1

/// Polar form of CIELAB: magnitude, saturation angle, hue angle.
struct Msh {
    double m, s, h;
};

Msh mshOf(QRgb rgb) {
    const auto linear = [](int v) {
        const double c = v / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double r = linear(qRed(rgb)), g = linear(qGreen(rgb)), b = linear(qBlue(rgb));
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double fx = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / kWhiteX);
    const double fy = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
    const double fz = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / kWhiteZ);
    const double l = 116.0 * fy - 16.0, a = 500.0 * (fx - fy), bb = 200.0 * (fy - fz);
    const double m = std::sqrt(l * l + a * a + bb * bb);
    return {m, std::acos(l / m), std::atan2(bb, a)};
}

QRgb rgbOf(const Msh& c) {
    const double l = c.m * std::cos(c.s);
    const double a = c.m * std::sin(c.s) * std::cos(c.h);
    const double b = c.m * std::sin(c.s) * std::sin(c.h);
    const auto inverse = [](double t) { return t > 0.206893 ? t * t * t : (t - 16.0 / 116.0) / 7.787; };
    const double fy = (l + 16.0) / 116.0;
    const double x = kWhiteX * inverse(fy + a / 500.0);
    const double y = inverse(fy);
    const double z = kWhiteZ * inverse(fy - b / 200.0);
    const auto byte = [](double v) {
        const double g = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
        return static_cast<int>(std::lround(255.0 * std::clamp(g, 0.0, 1.0)));
    };
    return qRgb(byte(3.2406 * x - 1.5372 * y - 0.4986 * z), byte(-0.9689 * x + 1.8758 * y + 0.0415 * z),
                byte(0.0557 * x - 0.2040 * y + 1.0570 * z));
}

/// Hue at the unsaturated end that keeps the step between neighbouring colours even.
double spunHue(const Msh& saturated, double unsaturated_m) {
    if (saturated.m >= unsaturated_m)
        return saturated.h;
    const double spin = saturated.s * std::sqrt(unsaturated_m * unsaturated_m - saturated.m * saturated.m) /
                        (saturated.m * std::sin(saturated.s));
    return saturated.h > -std::numbers::pi / 3.0 ? saturated.h + spin : saturated.h - spin;
}

ColourMap makeDiverging() {
    constexpr double kWhite_m = 88.0;
    const Msh low = mshOf(qRgb(59, 76, 192));
    const Msh high = mshOf(qRgb(180, 4, 38));
    const double middle_m = std::max({low.m, high.m, kWhite_m});
    ColourMap map{};
    for (int i = 0; i < kMapEntries; ++i) {
        const double share = i / (kMapEntries - 1.0);
        const Msh& end = share < 0.5 ? low : high;
        const double saturation = std::abs(2.0 * share - 1.0); // 1 at the ends
        const double h = spunHue(end, middle_m);
        map[static_cast<std::size_t>(i)] = rgbOf(
            {middle_m + saturation * (end.m - middle_m), saturation * end.s, h + saturation * (end.h - h)});
    }
    return map;
}

} // namespace

const ColourMap& cividis() {
    static const ColourMap map = [] {
        ColourMap opaque{};
        std::ranges::transform(kCividis, opaque.begin(), [](std::uint32_t rgb) { return 0xff000000U | rgb; });
        return opaque;
    }();
    return map;
}

const ColourMap& diverging() {
    static const ColourMap map = makeDiverging();
    return map;
}

QRgb colourAt(const ColourMap& map, double share) {
    if (!(share > 0.0))
        return map.front();
    if (share >= 1.0)
        return map.back();
    return map[static_cast<std::size_t>(share * (kMapEntries - 1) + 0.5)];
}

QColor identityColour(int identity, bool onDark) {
    const int index = ((identity - 1) % kIdentityColours + kIdentityColours) % kIdentityColours;
    return QColor((onDark ? kIdentityOnDark : kIdentityOnLight)[static_cast<std::size_t>(index)]);
}

} // namespace teleta::base
