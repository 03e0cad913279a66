// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"
#include "app/python/base/array_input.h"
#include "app/python/base/long_work.h"
#include "app/python/vision/vision_bindings.h"
#include "backend/scene_run/scene_run.h"
#include "backend/scene_run/study/study_run.h"

#include <QTemporaryDir>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::python {

namespace {

core::Expected<scene_run::SceneSummary> runAny(const std::string& pathOrName,
                                               scene_run::RunOptions& options) {
    TELETA_TRY(const app::AnyScene scene, app::readAnyScene(pathOrName));
    options.sceneText = app::readSceneText(pathOrName);
    if (const auto* const study = std::get_if<study::StudyScene>(&scene))
        return scene_run::runStudyScene(*study, options);
    return scene_run::runScene(std::get<scene::Scene>(scene), options);
}

/// Moves all files of a folder into another one, which is made when it is missing.
core::Expected<void> moveFiles(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code error;
    std::filesystem::create_directories(to, error);
    for (auto each = std::filesystem::directory_iterator(from, error);
         !error && each != std::filesystem::directory_iterator(); each.increment(error))
        std::filesystem::rename(each->path(), to / each->path().filename(), error);
    if (error)
        return core::Unexpected(
            core::Error{core::ErrorKind::ioFailed, error.message(), "a folder for the results", {to}});
    return {};
}

/// Files appear in the folder only when the run is whole: until then they are in one beside it.
core::Expected<scene_run::SceneSummary> runInto(const std::string& folder, const std::string& pathOrName,
                                                scene_run::RunOptions& options) {
    if (folder.empty())
        return runAny(pathOrName, options);
    const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
    const auto parent = (whole.has_filename() ? whole : whole.parent_path()).parent_path();
    std::error_code ignored;
    std::filesystem::create_directories(parent, ignored);
    const QTemporaryDir unfinished(QString::fromStdString((parent / ".teleta-unfinished-XXXXXX").string()));
    if (!unfinished.isValid())
        return core::Unexpected(core::Error{core::ErrorKind::ioFailed,
                                            unfinished.errorString().toStdString(),
                                            "a folder for the results",
                                            {folder}});
    options.outFolder = unfinished.path().toStdString();
    TELETA_TRY(scene_run::SceneSummary summary, runAny(pathOrName, options));
    if (!summary.interrupted)
        TELETA_CHECK(moveFiles(options.outFolder, whole));
    return summary;
}

/// summary.json as text, which Python's own reader takes.
std::string simulate(const py::object& scene, std::uint64_t seed, const std::optional<double>& duration_s,
                     const py::object& out, const py::object& progress) {
    const std::string pathOrName = pathOf(scene);
    scene_run::RunOptions options;
    options.name = std::filesystem::path(pathOrName).stem().string();
    options.seed = seed;
    if (duration_s)
        options.duration_s = positive(*duration_s, "duration_s");
    const std::string folder = out.is_none() ? std::string() : pathOf(out);
    LongWork work(progress);
    options.goOn = [&work](double done_s, double all_s) { return work.goOn(done_s, all_s); };
    std::optional<core::Expected<scene_run::SceneSummary>> summary;
    {
        const py::gil_scoped_release released;
        summary.emplace(runInto(folder, pathOrName, options));
    }
    const scene_run::SceneSummary done = work.valueOf(std::move(*summary));
    return done.toJson().dump();
}

} // namespace

void bindSimulation(py::module_& module) {
    module.def("simulate", &simulate);
    module.def("scenes", [] { return app::sceneNames(); });
}

} // namespace teleta::python
