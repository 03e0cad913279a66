// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// The parsers, and all code that a file reaches behind them, as functions of bytes. Entry points of
/// coverage-guided fuzzing (packaging/fuzz.sh) and of the replay of stored inputs (fuzz_regression_test.cpp).
/// Each returns whether the bytes were accepted, and ends the program when a contract is broken: an error
/// without a text or with a wrong place, a value out of range, something that is not read back as it was
/// written, an invalid operation or a division by zero in the numerics behind the parser. Thread: one.
namespace teleta::fuzz {

using Bytes = std::span<const std::uint8_t>;

// Readers of tables.
bool csv(Bytes bytes);
bool frameCsv(Bytes bytes);
bool frameNumpy(Bytes bytes);  ///< npy and npz
bool frameArrays(Bytes bytes); ///< HDF5 and MAT
bool frameTekscan(Bytes bytes);
bool frameTable(Bytes bytes); ///< of another program
bool gainCsv(Bytes bytes);    ///< of a 2 x 3 array
bool contourCsv(Bytes bytes);
bool touchCsv(Bytes bytes);
bool cameraPairs(Bytes bytes);
bool motorRecording(Bytes bytes);
bool levelCsv(Bytes bytes);
bool trialCsv(Bytes bytes);
bool servoCsv(Bytes bytes);
bool costCsv(Bytes bytes);

// Recordings.
bool recording(Bytes bytes);
bool mcapFile(Bytes bytes);
bool mcapMessage(Bytes bytes); ///< in CDR

// Patterns.
bool patternJson(Bytes bytes);
bool patternExport(Bytes bytes); ///< own format in, every other format out
bool patternAhap(Bytes bytes);
bool patternHjif(Bytes bytes);
bool patternHaptic(Bytes bytes);
bool patternHapticZip(Bytes bytes);
bool patternTact(Bytes bytes);
bool patternMap(Bytes bytes);
bool patternRecovery(Bytes bytes);

// Other documents.
bool scene(Bytes bytes);
bool studyProtocol(Bytes bytes);
bool studyScene(Bytes bytes);
bool trialJournal(Bytes bytes);
bool cameraJson(Bytes bytes);
bool motorProfile(Bytes bytes);
bool registerMap(Bytes bytes);
bool hidBraceletFile(Bytes bytes);
bool soundBraceletFile(Bytes bytes);
bool rosArmFile(Bytes bytes);
bool rosSensorFile(Bytes bytes); ///< of a force sensor, an array or a camera
bool taxelsFile(Bytes bytes);
bool urdf(Bytes bytes);
bool sitePermissions(Bytes bytes);
bool siteGovernance(Bytes bytes);
bool siteFile(Bytes bytes);
bool remoteSiteFile(Bytes bytes);
/// What a site tells of its streams.
bool siteStreams(Bytes bytes);

// What devices send.
bool wtsFrames(Bytes bytes);
bool taxelStream(Bytes bytes); ///< of described arrays
bool hidReports(Bytes bytes);
bool rosJointStates(Bytes bytes);    ///< messages in a form of the test, as the middleware hands them over
bool rosArrayMessages(Bytes bytes);  ///< the same of arrays
bool rosCameraMessages(Bytes bytes); ///< the same of cameras
bool rosFrames(Bytes bytes);         ///< the same of /tf and /tf_static
bool rosNodes(Bytes bytes);          ///< the same of ros_discovery_info
bool siteMotions(Bytes bytes);       ///< what a console asks of an arm

[[nodiscard]] inline std::string textOf(Bytes bytes) {
    return {bytes.begin(), bytes.end()};
}

} // namespace teleta::fuzz
