// SPDX-License-Identifier: GPL-3.0-or-later
#include "arm_physics.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tinyxml2.h>

namespace teleta::peer {

namespace {

using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

constexpr double kSphere_m = 0.0017;
constexpr double kBall_m = 0.012;
constexpr double kGap_m = 0.002;

/// A folder of its own for MuJoCo's files, removed at the end.
struct Folder {
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "ros-robot-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("no folder for the model's files");
        path = name;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    std::filesystem::path path;
};

std::array<double, 3> triple(const char* text) {
    std::array<double, 3> values{};
    if (text != nullptr) {
        std::istringstream stream(text);
        stream.imbue(std::locale::classic());
        stream >> values[0] >> values[1] >> values[2];
    }
    return values;
}

std::string attribute(const XMLElement* element, const char* name) {
    const char* value = element == nullptr ? nullptr : element->Attribute(name);
    if (value == nullptr)
        throw std::runtime_error(std::string("the URDF lacks an attribute ") + name);
    return value;
}

/// Roll, pitch and yaw about fixed axes.
std::array<double, 4> quaternion(const std::array<double, 3>& rpy) {
    const double cr = std::cos(rpy[0] / 2), sr = std::sin(rpy[0] / 2);
    const double cp = std::cos(rpy[1] / 2), sp = std::sin(rpy[1] / 2);
    const double cy = std::cos(rpy[2] / 2), sy = std::sin(rpy[2] / 2);
    return {sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy};
}

double massOf(const XMLElement* link) {
    const XMLElement* inertial = link->FirstChildElement("inertial");
    const XMLElement* mass = inertial == nullptr ? nullptr : inertial->FirstChildElement("mass");
    return mass == nullptr ? 0 : mass->DoubleAttribute("value");
}

/// What the file tells, after everything that MuJoCo is not to look at is taken out.
struct Description {
    std::vector<std::string> joints;
    std::vector<FixedFrame> fixedFrames;
    std::string lastLink;
    std::set<std::string> links;
};

Description prepare(XMLDocument& urdf) {
    XMLElement* robot = urdf.FirstChildElement("robot");
    if (robot == nullptr)
        throw std::runtime_error("the URDF has no <robot>");
    Description result;
    std::set<std::string> moving;
    for (XMLElement* joint = robot->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
        if (joint->FirstChildElement("mimic") != nullptr)
            throw std::runtime_error("joints with <mimic> are not played");
        const std::string child = attribute(joint->FirstChildElement("child"), "link");
        if (attribute(joint, "type") == "fixed") {
            const XMLElement* origin = joint->FirstChildElement("origin");
            result.fixedFrames.push_back({attribute(joint->FirstChildElement("parent"), "link"), child,
                                          triple(origin ? origin->Attribute("xyz") : nullptr),
                                          quaternion(triple(origin ? origin->Attribute("rpy") : nullptr))});
        } else {
            result.joints.push_back(attribute(joint, "name"));
            moving.insert(child);
        }
    }
    for (XMLElement* link = robot->FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
        for (const char* seen : {"visual", "collision"})
            while (XMLElement* shape = link->FirstChildElement(seen))
                link->DeleteChild(shape);
        result.lastLink = attribute(link, "name");
        result.links.insert(result.lastLink);
        if (moving.count(result.lastLink) != 0 && !(massOf(link) > 0)) {
            while (XMLElement* nothing = link->FirstChildElement("inertial"))
                link->DeleteChild(nothing);
            XMLElement* inertial = link->InsertNewChildElement("inertial");
            inertial->InsertNewChildElement("mass")->SetAttribute("value", 0.1);
            XMLElement* inertia = inertial->InsertNewChildElement("inertia");
            for (const char* diagonal : {"ixx", "iyy", "izz"})
                inertia->SetAttribute(diagonal, 0.001);
            for (const char* mixed : {"ixy", "ixz", "iyz"})
                inertia->SetAttribute(mixed, 0);
        }
    }
    if (result.joints.empty())
        throw std::runtime_error("the URDF has no movable joint");
    // A file may already say something to MuJoCo.
    while (XMLElement* own = robot->FirstChildElement("mujoco"))
        robot->DeleteChild(own);
    XMLElement* compiler = robot->InsertNewChildElement("mujoco")->InsertNewChildElement("compiler");
    compiler->SetAttribute("fusestatic", false);
    return result;
}

XMLElement* bodyNamed(XMLElement* in, const std::string& name) {
    for (XMLElement* body = in->FirstChildElement("body"); body != nullptr;
         body = body->NextSiblingElement("body")) {
        if (name == body->Attribute("name"))
            return body;
        if (XMLElement* found = bodyNamed(body, name))
            return found;
    }
    return nullptr;
}

void soften(XMLElement* in) {
    for (XMLElement* body = in->FirstChildElement("body"); body != nullptr;
         body = body->NextSiblingElement("body")) {
        for (XMLElement* joint = body->FirstChildElement("joint"); joint != nullptr;
             joint = joint->NextSiblingElement("joint")) {
            joint->SetAttribute("damping", 1);
            joint->SetAttribute("armature", 0.1);
        }
        soften(body);
    }
}

std::string numbers(double x, double y, double z) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << x << ' ' << y << ' ' << z;
    return text.str();
}

/// 84 spheres, each in a box that feels what touches it. One box as pad would give a few points of contact
/// only.
void addPad(XMLElement* mujoco, XMLElement* tip, XMLElement* sensor) {
    XMLElement* pairs = mujoco->InsertNewChildElement("contact");
    for (int row = 0; row < ArmPhysics::kRows; ++row)
        for (int column = 0; column < ArmPhysics::kColumns; ++column) {
            const std::string name = "taxel_" + std::to_string(row * ArmPhysics::kColumns + column);
            const std::string place =
                numbers((row - (ArmPhysics::kRows - 1) / 2.0) * ArmPhysics::kPitch_m,
                        (column - (ArmPhysics::kColumns - 1) / 2.0) * ArmPhysics::kPitch_m, 0);
            XMLElement* sphere = tip->InsertNewChildElement("geom");
            sphere->SetAttribute("name", name.c_str());
            sphere->SetAttribute("type", "sphere");
            sphere->SetAttribute("size", kSphere_m);
            sphere->SetAttribute("pos", place.c_str());
            sphere->SetAttribute("mass", 0);
            sphere->SetAttribute("contype", 0);
            sphere->SetAttribute("conaffinity", 0);
            XMLElement* box = tip->InsertNewChildElement("site");
            box->SetAttribute("name", name.c_str());
            box->SetAttribute("type", "box");
            box->SetAttribute("size",
                              numbers(ArmPhysics::kPitch_m / 2, ArmPhysics::kPitch_m / 2, 0.003).c_str());
            box->SetAttribute("pos", place.c_str());
            XMLElement* touch = sensor->InsertNewChildElement("touch");
            touch->SetAttribute("name", name.c_str());
            touch->SetAttribute("site", name.c_str());
            XMLElement* pair = pairs->InsertNewChildElement("pair");
            pair->SetAttribute("geom1", name.c_str());
            pair->SetAttribute("geom2", "pad_ball");
            pair->SetAttribute("condim", 1);
            pair->SetAttribute("solref", "0.01 1");
        }
    if (tip->FirstChildElement("inertial") == nullptr) {
        XMLElement* inertial = tip->InsertNewChildElement("inertial");
        inertial->SetAttribute("pos", "0 0 0");
        inertial->SetAttribute("mass", 0.01);
        inertial->SetAttribute("diaginertia", "1e-6 1e-6 1e-6");
    }
    XMLElement* ball = tip->InsertNewChildElement("body");
    ball->SetAttribute("name", "pad_ball");
    ball->SetAttribute("pos", numbers(0, 0, kSphere_m + kBall_m + kGap_m).c_str());
    XMLElement* slide = ball->InsertNewChildElement("joint");
    slide->SetAttribute("name", "pad_ball");
    slide->SetAttribute("type", "slide");
    slide->SetAttribute("axis", "0 0 1");
    slide->SetAttribute("damping", 20);
    XMLElement* geom = ball->InsertNewChildElement("geom");
    geom->SetAttribute("name", "pad_ball");
    geom->SetAttribute("type", "sphere");
    geom->SetAttribute("size", kBall_m);
    geom->SetAttribute("mass", 0.02);
    geom->SetAttribute("contype", 0);
    geom->SetAttribute("conaffinity", 0);
}

/// Puts servos, sensors and the solver's settings into the model that MuJoCo made of the URDF.
void complete(XMLDocument& model, const Description& description, const std::string& tip, bool withPad) {
    XMLElement* mujoco = model.FirstChildElement("mujoco");
    XMLElement* world = mujoco->FirstChildElement("worldbody");
    soften(world);
    XMLElement* option = mujoco->InsertNewChildElement("option");
    option->SetAttribute("timestep", ArmPhysics::kStep_s);
    option->SetAttribute("integrator", "implicit");
    if (XMLElement* size = mujoco->FirstChildElement("size"))
        mujoco->DeleteChild(size);
    XMLElement* actuator = mujoco->InsertNewChildElement("actuator");
    for (const std::string& joint : description.joints) {
        XMLElement* servo = actuator->InsertNewChildElement("velocity");
        servo->SetAttribute("name", joint.c_str());
        servo->SetAttribute("joint", joint.c_str());
        servo->SetAttribute("kv", 120);
        servo->SetAttribute("forcelimited", true);
        servo->SetAttribute("forcerange", "-90 90");
    }
    XMLElement* body = bodyNamed(world, tip);
    if (body == nullptr)
        throw std::runtime_error("the link " + tip + " is not one that MuJoCo keeps");
    XMLElement* site = body->InsertNewChildElement("site");
    site->SetAttribute("name", "tip");
    XMLElement* sensor = mujoco->InsertNewChildElement("sensor");
    for (const char* kind : {"force", "torque"}) {
        XMLElement* one = sensor->InsertNewChildElement(kind);
        one->SetAttribute("name", kind);
        one->SetAttribute("site", "tip");
    }
    if (withPad)
        addPad(mujoco, body, sensor);
}

int found(const mjModel* model, mjtObj kind, const std::string& name) {
    const int id = mj_name2id(model, kind, name.c_str());
    if (id < 0)
        throw std::runtime_error("MuJoCo does not know " + name);
    return id;
}

} // namespace

ArmPhysics::ArmPhysics(const std::string& urdf, const std::string& tip, bool withPad)
    : m_tip(tip) {
    load(urdf, withPad);
    m_data.reset(mj_makeData(m_model.get()));
    for (const std::string& name : m_joints) {
        const int joint = found(m_model.get(), mjOBJ_JOINT, name);
        m_positions.push_back(m_model->jnt_qposadr[joint]);
        m_velocities.push_back(m_model->jnt_dofadr[joint]);
        m_servos.push_back(found(m_model.get(), mjOBJ_ACTUATOR, name));
    }
    m_site = found(m_model.get(), mjOBJ_SITE, "tip");
    m_force = m_model->sensor_adr[found(m_model.get(), mjOBJ_SENSOR, "force")];
    m_torque = m_model->sensor_adr[found(m_model.get(), mjOBJ_SENSOR, "torque")];
    if (withPad) {
        m_ball = m_model->jnt_dofadr[found(m_model.get(), mjOBJ_JOINT, "pad_ball")];
        for (int i = 0; i < kRows * kColumns; ++i)
            m_touches.push_back(
                m_model->sensor_adr[found(m_model.get(), mjOBJ_SENSOR, "taxel_" + std::to_string(i))]);
    }
    mj_forward(m_model.get(), m_data.get());
}

ArmPhysics::~ArmPhysics() = default;

void ArmPhysics::load(const std::string& urdf, bool withPad) {
    const Folder folder;
    const std::string plain = folder.path / "plain.urdf";
    const std::string translated = folder.path / "translated.xml";
    const std::string finished = folder.path / "complete.xml";
    XMLDocument document;
    if (document.Parse(urdf.c_str()) != tinyxml2::XML_SUCCESS)
        throw std::runtime_error(std::string("the URDF is not XML: ") + document.ErrorStr());
    const Description description = prepare(document);
    m_joints = description.joints;
    m_fixedFrames = description.fixedFrames;
    if (m_tip.empty())
        m_tip = description.lastLink;
    if (description.links.count(m_tip) == 0)
        throw std::runtime_error("the URDF has no link " + m_tip);
    document.SaveFile(plain.c_str());

    char error[1000] = "";
    m_model.reset(mj_loadXML(plain.c_str(), nullptr, error, sizeof(error)));
    if (!m_model || mj_saveLastXML(translated.c_str(), m_model.get(), error, sizeof(error)) == 0)
        throw std::runtime_error(std::string("MuJoCo refused the URDF: ") + error);
    XMLDocument model;
    model.LoadFile(translated.c_str());
    complete(model, description, m_tip, withPad);
    model.SaveFile(finished.c_str());
    m_model.reset(mj_loadXML(finished.c_str(), nullptr, error, sizeof(error)));
    if (!m_model)
        throw std::runtime_error(std::string("MuJoCo refused the completed model: ") + error);
}

void ArmPhysics::place(std::span<const double> position_rad) {
    mj_resetData(m_model.get(), m_data.get());
    for (std::size_t i = 0; i < m_positions.size(); ++i)
        m_data->qpos[m_positions[i]] = position_rad[i];
    mj_forward(m_model.get(), m_data.get());
}

void ArmPhysics::step(std::span<const double> velocity_radPerS) {
    mj_step1(m_model.get(), m_data.get());
    for (std::size_t i = 0; i < m_servos.size(); ++i)
        m_data->ctrl[m_servos[i]] = velocity_radPerS[i];
    mju_copy(m_data->qfrc_applied, m_data->qfrc_bias, m_model->nv);
    if (m_ball >= 0)
        m_data->qfrc_applied[m_ball] -= m_press_N;
    // The force sensor counts what acts on bodies, so the push acts on the tip's body: at its centre of mass,
    // with the torque that brings it to the tip's origin.
    const int body = m_model->site_bodyid[m_site];
    mjtNum arm_m[3];
    mju_sub3(arm_m, &m_data->site_xpos[3 * m_site], &m_data->xipos[3 * body]);
    mju_copy3(&m_data->xfrc_applied[6 * body], m_push_N.data());
    mju_cross(&m_data->xfrc_applied[6 * body + 3], arm_m, m_push_N.data());
    mj_step2(m_model.get(), m_data.get());
}

std::vector<double> ArmPhysics::position_rad() const {
    std::vector<double> values;
    for (const int place : m_positions)
        values.push_back(m_data->qpos[place]);
    return values;
}

std::vector<double> ArmPhysics::ofJoints(const mjtNum* values) const {
    std::vector<double> result;
    for (const int place : m_velocities)
        result.push_back(values[place]);
    return result;
}

std::vector<double> ArmPhysics::velocity_radPerS() const {
    return ofJoints(m_data->qvel);
}

std::vector<double> ArmPhysics::effort_Nm(bool withGravity) const {
    std::vector<double> effort = ofJoints(m_data->qfrc_actuator);
    const std::vector<double> bias = ofJoints(m_data->qfrc_bias);
    for (std::size_t i = 0; withGravity && i < effort.size(); ++i)
        effort[i] += bias[i];
    return effort;
}

std::array<double, 6> ArmPhysics::wrench() const {
    // MuJoCo tells what the arm does to the tip.
    std::array<double, 6> result{};
    for (int i = 0; i < 3; ++i) {
        result[i] = -m_data->sensordata[m_force + i];
        result[3 + i] = -m_data->sensordata[m_torque + i];
    }
    return result;
}

std::vector<double> ArmPhysics::taxels_N() const {
    std::vector<double> result;
    for (const int place : m_touches)
        result.push_back(m_data->sensordata[place]);
    return result;
}

} // namespace teleta::peer
