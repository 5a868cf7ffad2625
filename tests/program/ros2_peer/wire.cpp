#include "tests/program/ros2_peer/wire.hpp"

#include <cstring>
#include <stdexcept>
#include <utility>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

namespace castaway::peer {
namespace {

/// A type whose samples are the serialised bytes.
class BytesType final : public dds::TopicDataType {
 public:
  explicit BytesType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = 4096;  // Grows.
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const auto& bytes = *static_cast<std::string*>(data);
    if (payload->max_size < bytes.size()) return false;
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    static_cast<std::string*>(data)->assign(reinterpret_cast<char*>(payload->data),
                                            payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<std::string*>(data)->size()); };
  }
  void* createData() override { return new std::string; }
  void deleteData(void* data) override { delete static_cast<std::string*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

template <typename Qos>
void set(const Quality& quality, Qos& qos) {
  qos.reliability().kind =
      quality.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind =
      quality.transient_local ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = quality.depth;
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

template <typename T>
T* made(T* object) {
  if (object == nullptr) throw std::runtime_error("Fast DDS refuses");
  return object;
}

}  // namespace

void Publications::on_publisher_discovery(dds::DomainParticipant*,
                                          rtps::WriterDiscoveryInfo&& info) {
  if (info.status != rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) return;
  const bool reliable = info.info.m_qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  const bool latched = info.info.m_qos.m_durability.kind == dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_[info.info.topicName().to_string()] = info.info.typeName().to_string() +
                                             (reliable ? " reliable" : " best_effort") +
                                             (latched ? " transient_local" : " volatile");
}

std::map<std::string, std::string> Publications::seen() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return seen_;
}

Wire::Wire(int domain, const std::string& range) {
  auto* factory = dds::DomainParticipantFactory::get_instance();
  dds::DomainParticipantQos qos = factory->get_default_participant_qos();
  if (range != "subnet") {
    const auto transport = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    if (range == "whitelist") transport->interfaceWhiteList.emplace_back("127.0.0.1");
    transport->maxInitialPeersRange = 32;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(transport);
  }
  if (range == "localhost") {
    auto& builtin = qos.wire_protocol().builtin;
    builtin.metatrafficMulticastLocatorList.clear();
    builtin.metatrafficUnicastLocatorList.push_back(rtps::Locator_t());
    rtps::Locator_t peer;
    rtps::IPLocator::setIPv4(peer, "127.0.0.1");
    builtin.initialPeersList.push_back(peer);
  }
  participant_ = made(factory->create_participant(static_cast<std::uint32_t>(domain), qos,
                                                  &publications_, dds::StatusMask::none()));
  publisher_ = made(participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT));
  subscriber_ = made(participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT));
}

Wire::~Wire() {
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* Wire::topic_of(const std::string& name, const std::string& type) {
  if (auto* known = dynamic_cast<dds::Topic*>(participant_->lookup_topicdescription(name))) {
    return known;
  }
  dds::TypeSupport(new BytesType(type)).register_type(participant_);
  return made(participant_->create_topic(name, type, dds::TOPIC_QOS_DEFAULT));
}

dds::DataReader* Wire::reader(const std::string& topic, const std::string& type,
                              const Quality& quality) {
  dds::DataReaderQos qos = subscriber_->get_default_datareader_qos();
  set(quality, qos);
  return made(subscriber_->create_datareader(topic_of(topic, type), qos));
}

dds::DataWriter* Wire::writer(const std::string& topic, const std::string& type,
                              const Quality& quality) {
  dds::DataWriterQos qos = publisher_->get_default_datawriter_qos();
  set(quality, qos);
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  return made(publisher_->create_datawriter(topic_of(topic, type), qos));
}

std::optional<std::string> take_bytes(dds::DataReader& reader) {
  std::string bytes;
  dds::SampleInfo info;
  while (reader.take_next_sample(&bytes, &info) ==
         eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
    if (info.valid_data) return bytes;
  }
  return std::nullopt;
}

void write_bytes(dds::DataWriter& writer, std::string bytes) { writer.write(&bytes); }

}  // namespace castaway::peer
