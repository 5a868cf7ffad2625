#include "tools/ros/dds/dds_participant.hpp"

#include <stdexcept>

#include <dds/dds.h>

#include "tools/ros/dds/dds_domain.hpp"
#include "tools/ros/dds/raw_type.hpp"

namespace castaway::testbed {
namespace {

using OwnedQos = std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)>;

OwnedQos make_qos(const DdsQos& qos) {
  OwnedQos made(dds_create_qos(), dds_delete_qos);
  dds_qset_reliability(made.get(),
                       qos.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_SECS(1));
  dds_qset_durability(
      made.get(), qos.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(made.get(), DDS_HISTORY_KEEP_LAST, qos.depth);
  dds_qset_ignorelocal(made.get(), DDS_IGNORELOCAL_PARTICIPANT);
  const dds_data_representation_id_t xcdr1 = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(made.get(), 1, &xcdr1);
  return made;
}

std::string name_of_policy(std::uint32_t policy) {
  switch (policy) {
    case DDS_RELIABILITY_QOS_POLICY_ID:
      return "reliability";
    case DDS_DURABILITY_QOS_POLICY_ID:
      return "durability";
    default:
      return "policy " + std::to_string(policy);
  }
}

}  // namespace

DdsEntity::DdsEntity(std::int32_t handle, const std::string& what) : handle_(handle) {
  require_dds(handle, what);
}

DdsEntity::~DdsEntity() {
  if (handle_ > 0) dds_delete(handle_);
}

void require_dds(std::int32_t code, const std::string& what) {
  if (code < 0) throw std::runtime_error("cannot " + what + ": " + dds_strretcode(code));
}

void DdsWriter::write(const std::string& bytes) {
  require_dds(dds_write(writer_.handle(), &bytes), "publish on " + name_);
}

int DdsWriter::readers() const {
  dds_publication_matched_status_t status{};
  dds_get_publication_matched_status(writer_.handle(), &status);
  return static_cast<int>(status.current_count);
}

std::optional<std::string> DdsWriter::refused() {
  dds_offered_incompatible_qos_status_t status{};
  dds_get_offered_incompatible_qos_status(writer_.handle(), &status);
  if (status.total_count_change == 0) return std::nullopt;
  return name_of_policy(status.last_policy_id);
}

std::optional<std::string> DdsReader::take() {
  while (true) {
    std::string bytes;
    void* sample = &bytes;
    dds_sample_info_t info{};
    if (dds_take(reader_.handle(), &sample, &info, 1, 1) <= 0) return std::nullopt;
    if (info.valid_data) return bytes;  // Otherwise a writer has gone.
  }
}

int DdsReader::writers() const {
  dds_subscription_matched_status_t status{};
  dds_get_subscription_matched_status(reader_.handle(), &status);
  return static_cast<int>(status.current_count);
}

DdsParticipant::DdsParticipant(const DdsNetwork& network)
    : domain_(DdsDomain::join(network)),
      participant_(
          dds_create_participant(static_cast<dds_domainid_t>(network.domain), nullptr, nullptr),
          "take part in domain " + std::to_string(network.domain)),
      waiting_(dds_create_waitset(participant_.handle()), "wait for messages") {}

DdsEntity DdsParticipant::make_topic(const DdsTopic& topic) {
  ddsi_sertype* type = make_raw_type(topic.type);
  return {dds_create_topic_sertype(participant_.handle(), topic.name.c_str(), &type, nullptr,
                                   nullptr, nullptr),
          "make topic " + topic.name};
}

DdsWriter DdsParticipant::writer(const DdsTopic& topic) {
  DdsEntity made = make_topic(topic);
  DdsEntity writer(
      dds_create_writer(participant_.handle(), made.handle(), make_qos(topic.qos).get(), nullptr),
      "publish on " + topic.name);
  return {std::move(made), std::move(writer), topic.name};
}

DdsReader DdsParticipant::reader(const DdsTopic& topic) {
  DdsEntity made = make_topic(topic);
  DdsEntity reader(
      dds_create_reader(participant_.handle(), made.handle(), make_qos(topic.qos).get(), nullptr),
      "subscribe to " + topic.name);
  require_dds(dds_set_status_mask(reader.handle(), DDS_DATA_AVAILABLE_STATUS),
              "watch " + topic.name);
  require_dds(dds_waitset_attach(waiting_.handle(), reader.handle(), 0), "watch " + topic.name);
  return {std::move(made), std::move(reader)};
}

bool DdsParticipant::wait(std::chrono::nanoseconds patience) {
  return dds_waitset_wait(waiting_.handle(), nullptr, 0, patience.count()) > 0;
}

}  // namespace castaway::testbed
