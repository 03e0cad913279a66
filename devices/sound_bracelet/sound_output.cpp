// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/sound_output.h"

#include "devices/sound_bracelet/alsa_output.h"
#include "devices/sound_bracelet/jack_output.h"

#include <QCoreApplication>

namespace teleta::sound {

namespace {

struct SoundFaultText {
    Q_DECLARE_TR_FUNCTIONS(SoundFaultText)
};

QString textOf(SoundFault fault) {
    switch (fault) {
    case SoundFault::none:
        break;
    case SoundFault::missedPeriod:
        return SoundFaultText::tr("Samples came too late while a tactor was driven.");
    case SoundFault::serverGone:
        return SoundFaultText::tr("The sound server stopped.");
    case SoundFault::deviceGone:
        return SoundFaultText::tr("The sound card is gone.");
    case SoundFault::rateChanged:
        return SoundFaultText::tr("The sound server changed its sample rate.");
    case SoundFault::periodChanged:
        return SoundFaultText::tr("The sound server changed its period.");
    case SoundFault::disconnected:
        return SoundFaultText::tr("A tactor was disconnected from its output.");
    case SoundFault::sharedWithOthers:
        return SoundFaultText::tr("Another program began to play on the sound card.");
    case SoundFault::callbacksStopped:
        return SoundFaultText::tr("The sound server stopped requesting samples.");
    }
    return {};
}

} // namespace

core::Expected<std::unique_ptr<SoundOutput>> openSoundOutput(const SoundBraceletFile& file,
                                                             ToneEngine& engine) {
    const auto asOutput = [](auto&& output) { return std::unique_ptr<SoundOutput>(std::move(output)); };
    if (file.address.api == SoundApi::alsa)
        return AlsaOutput::open(file, engine).map(asOutput);
    return JackOutput::open(file, engine).map(asOutput);
}

std::string describe(SoundFault fault) {
    return textOf(fault).toStdString();
}

} // namespace teleta::sound
