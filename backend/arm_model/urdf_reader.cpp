// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/urdf_reader.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <console_bridge/console.h>
#include <exception>
#include <limits>
#include <mutex>
#include <urdf_model/link.h>
#include <urdf_parser/urdf_parser.h>
#include <utility>

namespace teleta::arm_model {

namespace {

struct UrdfText {
    Q_DECLARE_TR_FUNCTIONS(UrdfText)
};

/// Deeper elements would exhaust the stack of the library's parser. A robot needs six levels.
constexpr int kDeepestElement = 32;

/// Larger numbers describe no robot and would overflow somewhere: m, rad, kg, factors.
constexpr double kLargestNumber = 1e6;

/// Not NaN either.
template <typename Numbers>
bool inRange(const Numbers& numbers) {
    return (numbers.array().abs() <= kLargestNumber).all();
}

bool inRange(double number) {
    return std::abs(number) <= kLargestNumber;
}

core::Unexpected bad(const std::string& file, const QString& message, const QString& expected = {},
                     long long line = 0, long long column = 0) {
    return core::Unexpected(core::Error{
        core::ErrorKind::badInput, message.toStdString(), expected.toStdString(), {file, line, column}});
}

/// Finds what the library cannot place, or does not survive: syntax, depth, xacro.
core::Expected<void> checkXml(std::string_view text, const std::string& file) {
    QXmlStreamReader xml(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())));
    int depth = 0;
    const auto fail = [&](const QString& message, const QString& expected) {
        return bad(file, message, expected, xml.lineNumber(), xml.columnNumber() + 1);
    };
    while (!xml.atEnd()) {
        const QXmlStreamReader::TokenType token = xml.readNext();
        if (token == QXmlStreamReader::EndElement)
            --depth;
        if (token == QXmlStreamReader::DTD)
            return fail(UrdfText::tr("there is a document type declaration"), UrdfText::tr("a plain URDF"));
        if (token != QXmlStreamReader::StartElement)
            continue;
        if (xml.prefix() == QLatin1String("xacro") ||
            xml.namespaceUri().endsWith(QLatin1String("wiki/xacro")))
            return fail(UrdfText::tr("this is xacro, not URDF"),
                        UrdfText::tr("the expanded text: xacro FILE > robot.urdf"));
        if (depth == 0 && xml.name() != QLatin1String("robot"))
            return fail(UrdfText::tr("the document is '%1'").arg(xml.name().toString().left(40)),
                        UrdfText::tr("<robot name=\"...\">"));
        if (++depth > kDeepestElement)
            return fail(UrdfText::tr("elements are nested more than %1 deep").arg(kDeepestElement),
                        UrdfText::tr("<robot> with <link> and <joint>"));
    }
    if (xml.hasError())
        return fail(xml.errorString(), UrdfText::tr("a well-formed XML document"));
    return {};
}

/// Keeps the first error that the library reports, which it would print otherwise.
class ErrorCatcher : public console_bridge::OutputHandler {
public:
    ErrorCatcher() { console_bridge::useOutputHandler(this); }
    ~ErrorCatcher() override { console_bridge::restorePreviousOutputHandler(); }
    ErrorCatcher(const ErrorCatcher&) = delete;
    ErrorCatcher& operator=(const ErrorCatcher&) = delete;

    void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
        if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first.empty())
            first = text;
    }

    std::string first;
};

/// Turns the library's tree into an ArmModel; remembers the first thing that is wrong with it.
class Builder {
public:
    Builder(const urdf::ModelInterface& source, const std::string& file)
        : m_source(source)
        , m_file(file) {}

    core::Expected<ArmModel> build() {
        m_model.name = m_source.getName();
        TELETA_CHECK(addLink(*m_source.getRoot()));
        // Without recursion: a chain of ten thousand links must not exhaust the stack.
        std::vector<const urdf::Link*> open{m_source.getRoot().get()};
        std::vector<std::size_t> indices{0};
        for (std::size_t next = 0; next < open.size(); ++next) {
            for (const urdf::JointSharedPtr& joint : open[next]->child_joints) {
                const urdf::LinkConstSharedPtr child = m_source.getLink(joint->child_link_name);
                TELETA_CHECK(addJoint(*joint, indices[next]));
                TELETA_CHECK(addLink(*child));
                open.push_back(child.get());
                indices.push_back(m_model.links.size() - 1);
            }
        }
        if (m_model.links.size() != m_source.links_.size())
            return bad(m_file, UrdfText::tr("some links hang on themselves"),
                       UrdfText::tr("a tree of links"));
        TELETA_CHECK(resolveMimics());
        return std::move(m_model);
    }

private:
    [[nodiscard]] core::Unexpected badLink(const std::string& link, const QString& what,
                                           const QString& expected) const {
        return bad(m_file, UrdfText::tr("link '%1': %2").arg(QString::fromStdString(link), what), expected);
    }
    [[nodiscard]] core::Unexpected badJoint(const std::string& joint, const QString& what,
                                            const QString& expected) const {
        return bad(m_file, UrdfText::tr("joint '%1': %2").arg(QString::fromStdString(joint), what), expected);
    }

    static QString range() { return UrdfText::tr("numbers from -%1 to %1").arg(kLargestNumber); }

    static Eigen::Vector3d vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

    static Eigen::Isometry3d pose(const urdf::Pose& source) {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.translation() = vector(source.position);
        const urdf::Rotation& r = source.rotation;
        pose.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
        return pose;
    }

    core::Expected<void> addLink(const urdf::Link& source) {
        ModelLink link;
        link.name = source.name;
        if (source.inertial) {
            link.inertial = Inertial{source.inertial->mass, vector(source.inertial->origin.position)};
            if (!inRange(link.inertial->mass_kg) || !inRange(link.inertial->p_Link_Com_m))
                return badLink(source.name, UrdfText::tr("a number of its inertial is out of range"),
                               range());
            if (link.inertial->mass_kg < 0.0)
                return badLink(source.name, UrdfText::tr("its mass is negative"),
                               UrdfText::tr("0 kg or more"));
        }
        for (const urdf::VisualSharedPtr& visual : source.visual_array) {
            if (!visual->geometry)
                continue;
            link.visuals.push_back(shape(*visual));
            if (!inRange(link.visuals.back().X_Link_Shape.matrix()) || !inRange(link.visuals.back().size))
                return badLink(source.name, UrdfText::tr("a number of its visual is out of range"), range());
        }
        m_model.links.push_back(std::move(link));
        return {};
    }

    static Visual shape(const urdf::Visual& source) {
        Visual visual;
        visual.X_Link_Shape = pose(source.origin);
        const urdf::Geometry& geometry = *source.geometry;
        switch (geometry.type) {
        case urdf::Geometry::BOX:
            visual.kind = ShapeKind::box;
            visual.size = vector(static_cast<const urdf::Box&>(geometry).dim);
            break;
        case urdf::Geometry::CYLINDER: {
            const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
            visual.kind = ShapeKind::cylinder;
            visual.size = {cylinder.radius, cylinder.length, 0.0};
            break;
        }
        case urdf::Geometry::SPHERE:
            visual.kind = ShapeKind::sphere;
            visual.size = {static_cast<const urdf::Sphere&>(geometry).radius, 0.0, 0.0};
            break;
        case urdf::Geometry::MESH: {
            const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
            visual.kind = ShapeKind::mesh;
            visual.mesh = mesh.filename;
            visual.size = vector(mesh.scale);
            break;
        }
        }
        if (source.material) {
            const urdf::Color& colour = source.material->color;
            visual.colour = Eigen::Vector4f(colour.r, colour.g, colour.b, colour.a);
        }
        return visual;
    }

    core::Expected<void> addJoint(const urdf::Joint& source, std::size_t parentLink) {
        ModelJoint joint;
        joint.name = source.name;
        joint.parentLink = parentLink;
        joint.X_Parent_Joint = pose(source.parent_to_joint_origin_transform);
        switch (source.type) {
        case urdf::Joint::REVOLUTE:
            joint.type = JointType::revolute;
            break;
        case urdf::Joint::CONTINUOUS:
            joint.type = JointType::continuous;
            break;
        case urdf::Joint::PRISMATIC:
            joint.type = JointType::prismatic;
            break;
        case urdf::Joint::FIXED:
            joint.type = JointType::fixed;
            break;
        default:
            return badJoint(source.name, UrdfText::tr("it is floating or planar"),
                            UrdfText::tr("revolute, continuous, prismatic or fixed"));
        }
        if (!inRange(joint.X_Parent_Joint.matrix()))
            return badJoint(source.name, UrdfText::tr("a number of its origin is out of range"), range());
        if (joint.type != JointType::fixed) {
            TELETA_CHECK(setAxis(source, joint));
            TELETA_CHECK(setLimits(source, joint));
        }
        m_model.joints.push_back(std::move(joint));
        return {};
    }

    core::Expected<void> setAxis(const urdf::Joint& source, ModelJoint& joint) const {
        const Eigen::Vector3d axis = vector(source.axis);
        const double length = axis.stableNorm();
        if (!std::isfinite(length) || !(length > 0.0))
            return badJoint(source.name, UrdfText::tr("its axis has no direction"),
                            UrdfText::tr("<axis xyz=\"...\"> other than 0 0 0"));
        joint.axis = (axis / length).stableNormalized();
        return {};
    }

    core::Expected<void> setLimits(const urdf::Joint& source, ModelJoint& joint) const {
        if (joint.type == JointType::continuous) {
            joint.lowest = -std::numeric_limits<double>::infinity();
            joint.highest = std::numeric_limits<double>::infinity();
        }
        if (!source.limits) {
            if (joint.type != JointType::continuous)
                return badJoint(source.name, UrdfText::tr("it has no limits"),
                                UrdfText::tr("<limit lower= upper= effort= velocity=>"));
            return {};
        }
        const urdf::JointLimits& limits = *source.limits;
        // Effort and velocity without an end are written as any large number.
        if (!inRange(limits.lower) || !inRange(limits.upper) || !std::isfinite(limits.velocity) ||
            !std::isfinite(limits.effort))
            return badJoint(source.name, UrdfText::tr("a number of its limits is out of range"), range());
        if (limits.velocity < 0.0 || limits.effort < 0.0)
            return badJoint(source.name, UrdfText::tr("a limit of velocity or effort is negative"),
                            UrdfText::tr("0 or more"));
        if (joint.type != JointType::continuous) {
            if (limits.lower > limits.upper)
                return badJoint(source.name, UrdfText::tr("its lower limit lies above the upper one"),
                                UrdfText::tr("lower <= upper"));
            joint.lowest = limits.lower;
            joint.highest = limits.upper;
        }
        joint.fastest = std::min(limits.velocity, kLargestNumber);
        joint.strongest = std::min(limits.effort, kLargestNumber);
        return {};
    }

    /// Follows each mimic joint to the joint that nothing moves but a command.
    core::Expected<void> resolveMimics() {
        for (ModelJoint& joint : m_model.joints) {
            std::string name = joint.name;
            Mimic mimic;
            for (std::size_t steps = 0;; ++steps) {
                const urdf::JointConstSharedPtr source = m_source.getJoint(name);
                if (!source->mimic)
                    break;
                if (steps > m_model.joints.size())
                    return badJoint(joint.name, UrdfText::tr("it mimics itself"),
                                    UrdfText::tr("a mimic of another joint"));
                const std::optional<std::size_t> followed = m_model.findJoint(source->mimic->joint_name);
                if (!followed)
                    return badJoint(joint.name,
                                    UrdfText::tr("it mimics '%1', which does not exist")
                                        .arg(QString::fromStdString(source->mimic->joint_name)),
                                    UrdfText::tr("the name of a joint"));
                mimic.followed = *followed;
                mimic.offset += mimic.factor * source->mimic->offset;
                mimic.factor *= source->mimic->multiplier;
                if (!inRange(mimic.factor) || !inRange(mimic.offset))
                    return badJoint(joint.name, UrdfText::tr("a number of its mimic is out of range"),
                                    range());
                joint.mimic = mimic;
                name = source->mimic->joint_name;
            }
        }
        return {};
    }

    const urdf::ModelInterface& m_source;
    const std::string& m_file;
    ArmModel m_model;
};

} // namespace

core::Expected<ArmModel> parseUrdf(std::string_view text, const std::string& file) {
    if (text.size() > kLargestUrdf_bytes)
        return bad(file, UrdfText::tr("the text has %1 bytes").arg(text.size()),
                   UrdfText::tr("at most %1").arg(kLargestUrdf_bytes));
    TELETA_CHECK(checkXml(text, file));

    // The library reports errors through one handler for the whole program.
    static std::mutex oneReader;
    const std::scoped_lock lock(oneReader);
    ErrorCatcher errors;
    urdf::ModelInterfaceSharedPtr parsed;
    try {
        parsed = urdf::parseURDF(std::string(text));
    } catch (const std::exception& exception) {
        errors.first = exception.what();
    }
    if (!parsed || !parsed->getRoot())
        return bad(file,
                   errors.first.empty() ? UrdfText::tr("this is not a robot")
                                        : UrdfText::tr("this cannot be read as a robot (%1)")
                                              .arg(QString::fromStdString(errors.first)),
                   UrdfText::tr("a tree of links and joints, http://wiki.ros.org/urdf/XML"));
    TELETA_TRY(ArmModel model, Builder(*parsed, file).build());
    model.urdf = text;
    return model;
}

core::Expected<ArmModel> readUrdf(const std::string& path) {
    const QFileInfo info(QString::fromStdString(path));
    if (!info.exists())
        return core::Unexpected(core::Error{core::ErrorKind::notFound,
                                            UrdfText::tr("the file does not exist").toStdString(),
                                            UrdfText::tr("a URDF file").toStdString(),
                                            {path}});
    if (!info.isFile())
        return bad(path, UrdfText::tr("this is not a file"), UrdfText::tr("a URDF file"));
    if (info.size() > static_cast<qint64>(kLargestUrdf_bytes))
        return bad(path, UrdfText::tr("the file has %1 bytes").arg(info.size()),
                   UrdfText::tr("at most %1").arg(kLargestUrdf_bytes));
    QFile file(info.filePath());
    if (!file.open(QIODevice::ReadOnly))
        return core::Unexpected(
            core::Error{core::ErrorKind::ioFailed, file.errorString().toStdString(), {}, {path}});
    const QByteArray text = file.read(static_cast<qint64>(kLargestUrdf_bytes) + 1);
    return parseUrdf({text.constData(), static_cast<std::size_t>(text.size())}, path);
}

} // namespace teleta::arm_model
