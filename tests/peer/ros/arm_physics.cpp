// SPDX-License-Identifier: GPL-3.0-or-later
#include "arm_physics.h"

#include <algorithm>
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

constexpr double kDamping_NmsPerRad = 1;
constexpr double kArmature_kgm2 = 0.1;
constexpr double kServo_NmsPerRad = 120;
constexpr double kStrongest_Nm = 90;

constexpr double kSphere_m = 0.0017;
constexpr double kBall_m = 0.012;
constexpr double kGap_m = 0.002;
constexpr double kPlate_m = 0.002; ///< half of its thickness
constexpr int kTaxels = ArmPhysics::kRows * ArmPhysics::kColumns;

std::string objectName(std::size_t object) {
    return "object_" + std::to_string(object);
}

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
    std::vector<LinkFrame> fixedFrames;
    std::vector<std::string> movingLinks;
    std::string lastLink;
    std::string root;
    std::set<std::string> links;
};

Description prepare(XMLDocument& urdf) {
    XMLElement* robot = urdf.FirstChildElement("robot");
    if (robot == nullptr)
        throw std::runtime_error("the URDF has no <robot>");
    Description result;
    std::set<std::string> moving;
    std::set<std::string> children;
    for (XMLElement* joint = robot->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
        if (joint->FirstChildElement("mimic") != nullptr)
            throw std::runtime_error("joints with <mimic> are not played");
        const std::string child = attribute(joint->FirstChildElement("child"), "link");
        children.insert(child);
        if (attribute(joint, "type") == "fixed") {
            const XMLElement* origin = joint->FirstChildElement("origin");
            result.fixedFrames.push_back({attribute(joint->FirstChildElement("parent"), "link"), child,
                                          triple(origin ? origin->Attribute("xyz") : nullptr),
                                          quaternion(triple(origin ? origin->Attribute("rpy") : nullptr))});
        } else {
            result.joints.push_back(attribute(joint, "name"));
            moving.insert(child);
            result.movingLinks.push_back(child);
        }
    }
    for (XMLElement* link = robot->FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
        for (const char* seen : {"visual", "collision"})
            while (XMLElement* shape = link->FirstChildElement(seen))
                link->DeleteChild(shape);
        result.lastLink = attribute(link, "name");
        result.links.insert(result.lastLink);
        if (children.count(result.lastLink) == 0)
            result.root = result.lastLink;
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
            joint->SetAttribute("damping", kDamping_NmsPerRad);
            joint->SetAttribute("armature", kArmature_kgm2);
        }
        soften(body);
    }
}

std::string numbers(double x, double y) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << x << ' ' << y;
    return text.str();
}

std::string numbers(double x, double y, double z) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << x << ' ' << y << ' ' << z;
    return text.str();
}

XMLElement* addSphere(XMLElement* body, const std::string& name, double radius_m, double mass_kg) {
    XMLElement* sphere = body->InsertNewChildElement("geom");
    sphere->SetAttribute("name", name.c_str());
    sphere->SetAttribute("type", "sphere");
    sphere->SetAttribute("size", radius_m);
    sphere->SetAttribute("mass", mass_kg);
    sphere->SetAttribute("contype", 0);
    sphere->SetAttribute("conaffinity", 0);
    return sphere;
}

/// Without friction.
XMLElement* addPair(XMLElement* pairs, const std::string& one, const std::string& other) {
    XMLElement* pair = pairs->InsertNewChildElement("pair");
    pair->SetAttribute("geom1", one.c_str());
    pair->SetAttribute("geom2", other.c_str());
    pair->SetAttribute("condim", 1);
    return pair;
}

std::string taxelName(int taxel) {
    return "taxel_" + std::to_string(taxel);
}

std::string taxelPlace(int taxel) {
    const int row = taxel / ArmPhysics::kColumns;
    const int column = taxel % ArmPhysics::kColumns;
    return numbers((column - (ArmPhysics::kColumns - 1) / 2.0) * ArmPhysics::kPitch_m,
                   (row - (ArmPhysics::kRows - 1) / 2.0) * ArmPhysics::kPitch_m, 0);
}

/// Boxes that feel what touches the tip in them.
void addTaxels(XMLElement* tip, XMLElement* sensor) {
    for (int taxel = 0; taxel < kTaxels; ++taxel) {
        XMLElement* box = tip->InsertNewChildElement("site");
        box->SetAttribute("name", taxelName(taxel).c_str());
        box->SetAttribute("type", "box");
        box->SetAttribute("size", numbers(ArmPhysics::kPitch_m / 2, ArmPhysics::kPitch_m / 2, 0.003).c_str());
        box->SetAttribute("pos", taxelPlace(taxel).c_str());
        XMLElement* touch = sensor->InsertNewChildElement("touch");
        touch->SetAttribute("name", taxelName(taxel).c_str());
        touch->SetAttribute("site", taxelName(taxel).c_str());
    }
    if (tip->FirstChildElement("inertial") == nullptr) {
        XMLElement* inertial = tip->InsertNewChildElement("inertial");
        inertial->SetAttribute("pos", "0 0 0");
        inertial->SetAttribute("mass", 0.01);
        inertial->SetAttribute("diaginertia", "1e-6 1e-6 1e-6");
    }
}

/// A sphere in each taxel, and the ball that presses on them. One box as pad would give a few points of
/// contact only.
void addSpheres(XMLElement* pairs, XMLElement* tip) {
    for (int taxel = 0; taxel < kTaxels; ++taxel) {
        addSphere(tip, taxelName(taxel), kSphere_m, 0)->SetAttribute("pos", taxelPlace(taxel).c_str());
        addPair(pairs, taxelName(taxel), "pad_ball")->SetAttribute("solref", "0.01 1");
    }
    XMLElement* ball = tip->InsertNewChildElement("body");
    ball->SetAttribute("name", "pad_ball");
    ball->SetAttribute("pos", numbers(0, 0, kSphere_m + kBall_m + kGap_m).c_str());
    XMLElement* slide = ball->InsertNewChildElement("joint");
    slide->SetAttribute("name", "pad_ball");
    slide->SetAttribute("type", "slide");
    slide->SetAttribute("axis", "0 0 1");
    slide->SetAttribute("damping", 20);
    addSphere(ball, "pad_ball", kBall_m, 0.02);
}

/// One hard plate, and balls on springs in the world. A contact yields by (1 - d) / d of its force over the
/// moved mass and the square of solref: with these numbers a thousandth of what the hardest object does.
void addObjects(XMLElement* pairs, XMLElement* tip, XMLElement* world,
                const std::vector<SoftObject>& objects) {
    constexpr double kMass_kg = 0.02;
    constexpr double kDampingRatio = 0.1;
    XMLElement* plate = tip->InsertNewChildElement("geom");
    plate->SetAttribute("name", "plate");
    plate->SetAttribute("type", "box");
    plate->SetAttribute("size", numbers(ArmPhysics::kColumns * ArmPhysics::kPitch_m / 2,
                                        ArmPhysics::kRows * ArmPhysics::kPitch_m / 2, kPlate_m)
                                    .c_str());
    plate->SetAttribute("pos", numbers(0, 0, -kPlate_m).c_str());
    plate->SetAttribute("mass", 0);
    plate->SetAttribute("contype", 0);
    plate->SetAttribute("conaffinity", 0);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const SoftObject& object = objects[i];
        const std::string name = objectName(i);
        XMLElement* body = world->InsertNewChildElement("body");
        body->SetAttribute("name", name.c_str());
        body->SetAttribute("pos",
                           numbers(object.position_m[0], object.position_m[1], object.position_m[2]).c_str());
        XMLElement* slide = body->InsertNewChildElement("joint");
        slide->SetAttribute("name", name.c_str());
        slide->SetAttribute("type", "slide");
        slide->SetAttribute("axis", "0 0 1");
        slide->SetAttribute("stiffness", object.stiffness_NPerM);
        slide->SetAttribute("damping", 2 * kDampingRatio * std::sqrt(object.stiffness_NPerM * kMass_kg));
        addSphere(body, name, ArmPhysics::kObjectRadius_m, kMass_kg);
        XMLElement* pair = addPair(pairs, "plate", name);
        pair->SetAttribute("solref", "0.004 1");
        pair->SetAttribute("solimp", "0.9999 0.9999 0.001");
    }
}

/// Puts servos, sensors and the solver's settings into the model that MuJoCo made of the URDF.
void complete(XMLDocument& model, const Description& description, const std::string& tip, bool withPad,
              const std::vector<SoftObject>& objects) {
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
        servo->SetAttribute("kv", kServo_NmsPerRad);
        servo->SetAttribute("forcelimited", true);
        servo->SetAttribute("forcerange", numbers(-kStrongest_Nm, kStrongest_Nm).c_str());
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
    if (!withPad)
        return;
    addTaxels(body, sensor);
    XMLElement* pairs = mujoco->InsertNewChildElement("contact");
    if (objects.empty())
        addSpheres(pairs, body);
    else
        addObjects(pairs, body, world, objects);
}

int found(const mjModel* model, mjtObj kind, const std::string& name) {
    const int id = mj_name2id(model, kind, name.c_str());
    if (id < 0)
        throw std::runtime_error("MuJoCo does not know " + name);
    return id;
}

} // namespace

ArmPhysics::ArmPhysics(const std::string& urdf, const std::string& tip, bool withPad,
                       const std::vector<SoftObject>& objects)
    : m_tip(tip) {
    if (!withPad && !objects.empty())
        throw std::runtime_error("objects need a pad");
    load(urdf, withPad, objects);
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
    if (withPad && objects.empty())
        m_ball = m_model->jnt_dofadr[found(m_model.get(), mjOBJ_JOINT, "pad_ball")];
    for (int i = 0; withPad && i < kTaxels; ++i)
        m_touches.push_back(m_model->sensor_adr[found(m_model.get(), mjOBJ_SENSOR, taxelName(i))]);
    for (std::size_t i = 0; i < objects.size(); ++i)
        m_objects.push_back(m_model->jnt_qposadr[found(m_model.get(), mjOBJ_JOINT, objectName(i))]);
    mj_forward(m_model.get(), m_data.get());
    m_sensorTorque_Nm.assign(m_joints.size(), 0.0);
}

ArmPhysics::~ArmPhysics() = default;

void ArmPhysics::load(const std::string& urdf, bool withPad, const std::vector<SoftObject>& objects) {
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
    m_movingLinks = description.movingLinks;
    m_root = description.root;
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
    complete(model, description, m_tip, withPad, objects);
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
    const std::vector<double> before_radPerS = ofJoints(m_data->qvel);
    mj_step2(m_model.get(), m_data.get());
    // The integrator is implicit in the velocity: servo and damping act with that of the step's end.
    const std::vector<double> after_radPerS = ofJoints(m_data->qvel);
    m_sensorTorque_Nm.resize(after_radPerS.size());
    for (std::size_t i = 0; i < after_radPerS.size(); ++i)
        m_sensorTorque_Nm[i] = std::clamp(kServo_NmsPerRad * (velocity_radPerS[i] - after_radPerS[i]),
                                          -kStrongest_Nm, kStrongest_Nm) -
                               kDamping_NmsPerRad * after_radPerS[i] -
                               kArmature_kgm2 * (after_radPerS[i] - before_radPerS[i]) / kStep_s;
}

std::vector<LinkFrame> ArmPhysics::movingFrames() {
    mj_kinematics(m_model.get(), m_data.get()); // a step leaves them where they were before it
    std::vector<LinkFrame> frames;
    for (const std::string& link : m_movingLinks) {
        const int body = found(m_model.get(), mjOBJ_BODY, link);
        const mjtNum* p = &m_data->xpos[3 * body];
        const mjtNum* q = &m_data->xquat[4 * body];
        frames.push_back({m_root, link, {p[0], p[1], p[2]}, {q[1], q[2], q[3], q[0]}});
    }
    return frames;
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

std::vector<double> ArmPhysics::depth_m() const {
    std::vector<double> result;
    for (const int place : m_objects)
        result.push_back(-m_data->qpos[place]);
    return result;
}

} // namespace teleta::peer
