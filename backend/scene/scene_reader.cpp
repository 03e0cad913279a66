// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include "backend/core/keys/toml_keys.h"

namespace teleta::scene {

namespace {

core::Expected<Scene> readDocument(const core::TomlDocument& document) {
    core::TomlTable root = document.root();
    core::TomlKeys keys(root, core::TomlKeys::Nested::afterwards);
    Scene scene;
    scene.describeHead(keys);
    if (root.has("arm"))
        scene.world = ArmWorld();
    else if (root.has("robot"))
        scene.world = ServoWorld();
    else if (root.has("camera"))
        scene.world = CameraWorld();
    else if (root.has("gel"))
        scene.world = GelWorld();
    scene.describeWorld(keys);
    scene.describeEffects(keys);
    keys.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return scene;
}

} // namespace

core::Expected<Scene> readScene(const std::string& path) {
    return core::TomlDocument::open(path).and_then(readDocument);
}

core::Expected<Scene> parseScene(std::string_view text, const std::string& file) {
    return core::TomlDocument::parse(text, file).and_then(readDocument);
}

} // namespace teleta::scene
