// SPDX-License-Identifier: GPL-3.0-or-later
#include "dds_node.h"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <memory>
#include <stdexcept>

namespace teleta::peer {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

template <class Handle>
Handle* made(Handle* handle, const std::string& what) {
    if (handle == nullptr)
        throw std::runtime_error("Fast DDS made no " + what);
    return handle;
}

template <class Qos>
void set(Qos& qos, const EndQos& wanted) {
    qos.reliability().kind =
        wanted.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
    qos.durability().kind =
        wanted.transientLocal ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
    qos.history().depth = wanted.depth;
    qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    qos.data_sharing().off();
}

} // namespace

DdsNode::DdsNode(int domain) {
    dds::DomainParticipantFactory* factory = dds::DomainParticipantFactory::get_instance();
    dds::DomainParticipantQos qos;
    qos.name("ros_robot");
    auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList = {"127.0.0.1"};
    udp->maxInitialPeersRange = 10;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(udp);

    // Port 0: the port that the domain and the number of the participant give.
    rtps::Locator_t loopback;
    loopback.kind = LOCATOR_KIND_UDPv4;
    rtps::IPLocator::setIPv4(loopback, 127, 0, 0, 1);
    loopback.port = 0;
    auto& builtin = qos.wire_protocol().builtin;
    builtin.initialPeersList.push_back(loopback);
    // A unicast locator of its own, so that Fast DDS adds no multicast one.
    builtin.metatrafficUnicastLocatorList.push_back(loopback);

    m_participant = made(factory->create_participant(static_cast<std::uint32_t>(domain), qos), "participant");
    m_publisher = made(m_participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT), "publisher");
    m_subscriber = made(m_participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT), "subscriber");
}

DdsNode::~DdsNode() {
    if (m_participant == nullptr)
        return;
    m_participant->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(m_participant);
}

dds::Topic* DdsNode::topicOf(const std::string& name, const dds::TypeSupport& type) {
    const std::string onWire = "rt" + name;
    if (dds::TopicDescription* known = m_participant->lookup_topicdescription(onWire))
        return static_cast<dds::Topic*>(known);
    if (type.register_type(m_participant) != ReturnCode_t::RETCODE_OK)
        throw std::runtime_error("Fast DDS refused the type " + type.get_type_name());
    return made(m_participant->create_topic(onWire, type.get_type_name(), dds::TOPIC_QOS_DEFAULT),
                "topic " + onWire);
}

dds::DataWriter* DdsNode::write(const std::string& topic, dds::TypeSupport type, const EndQos& wanted,
                                dds::DataWriterListener* listener) {
    dds::DataWriterQos qos;
    set(qos, wanted);
    qos.reliability().max_blocking_time = {0, 5'000'000};
    qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
    return made(m_publisher->create_datawriter(topicOf(topic, type), qos, listener), "writer of " + topic);
}

dds::DataReader* DdsNode::read(const std::string& topic, dds::TypeSupport type, const EndQos& wanted,
                               dds::DataReaderListener* listener) {
    dds::DataReaderQos qos;
    set(qos, wanted);
    return made(m_subscriber->create_datareader(topicOf(topic, type), qos, listener), "reader of " + topic);
}

void DdsNode::remove(dds::DataWriter* writer) {
    m_publisher->delete_datawriter(writer);
}

} // namespace teleta::peer
