#include "tools/scenario/sections/output_yaml.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

OutputSpec outputs_of(const std::string& text) {
  YamlDocument document = YamlDocument::parse(text, "scenario.yaml");
  YamlReader root = document.root();
  const OutputSpec outputs = read_outputs(root);
  document.reject_unknown_keys();
  return outputs;
}

std::string output_refusal(const std::string& text) {
  return error_of([&] { (void)outputs_of(text); });
}

TEST(OutputSpec, HasADefaultForEveryKey) {
  const OutputSpec outputs = outputs_of("{}");
  EXPECT_TRUE(outputs.report);
  EXPECT_TRUE(outputs.player);
  EXPECT_TRUE(outputs.snapshots);
  EXPECT_FALSE(outputs.scans);
  EXPECT_EQ(outputs.points_every_s, 0.0);
  EXPECT_EQ(outputs.video.format.fps, 20);
  EXPECT_EQ(outputs.video.view, FilmView::kChase);
}

TEST(OutputSpec, TablesComeInTwoKinds) {
  EXPECT_FALSE(outputs_of("{}").tables_csv || outputs_of("{}").tables_hdf5);
  EXPECT_TRUE(outputs_of("outputs: {tables: csv}").tables_csv);
  EXPECT_FALSE(outputs_of("outputs: {tables: csv}").tables_hdf5);
  EXPECT_TRUE(outputs_of("outputs: {tables: [csv, hdf5]}").tables_csv);
  EXPECT_TRUE(outputs_of("outputs: {tables: [csv, hdf5]}").tables_hdf5);
  EXPECT_TRUE(contains(output_refusal("outputs: {tables: hdf}"),
                       "'hdf' is not a kind of table; did you mean 'hdf5'?"));
}

TEST(OutputSpec, ReadsAllKeys) {
  const OutputSpec outputs = outputs_of(
      "outputs: {report: false, player: false, scans: true, points: {every_s: 2}, snapshots: "
      "{every_s: 5, on_events: false, width: 320, height: 240}, video: {width: 640, height: "
      "360, fps: 25, speed: 4, view: map}}");
  EXPECT_FALSE(outputs.report);
  EXPECT_FALSE(outputs.player);
  EXPECT_TRUE(outputs.scans);
  EXPECT_EQ(outputs.points_every_s, 2.0);
  EXPECT_EQ(outputs.pictures.every_s, 5.0);
  EXPECT_FALSE(outputs.pictures.on_events);
  EXPECT_EQ(outputs.pictures.width, 320);
  EXPECT_EQ(outputs.pictures.height, 240);
  EXPECT_EQ(outputs.video.format.width, 640);
  EXPECT_EQ(outputs.video.format.height, 360);
  EXPECT_EQ(outputs.video.format.fps, 25);
  EXPECT_EQ(outputs.video.speed, 4.0);
  EXPECT_EQ(outputs.video.view, FilmView::kMap);
}

TEST(OutputSpec, ReadsFormatsOfOtherTools) {
  const OutputSpec none = outputs_of("{}");
  EXPECT_FALSE(none.bag || none.carmen || none.kitti || none.map);
  const OutputSpec all = outputs_of(
      "outputs: {bag: {compression: lz4, particles: true, snapshots: true}, carmen: true, kitti: "
      "true, map: true}");
  ASSERT_TRUE(all.bag);
  EXPECT_EQ(all.bag->compression, Compression::kLz4);
  EXPECT_TRUE(all.bag->particles);
  EXPECT_TRUE(all.bag->snapshots);
  EXPECT_TRUE(all.carmen && all.kitti && all.map);
}

TEST(OutputSpec, ABagMayBeOneWord) {
  ASSERT_TRUE(outputs_of("outputs: {bag: true}").bag);
  EXPECT_EQ(outputs_of("outputs: {bag: true}").bag->compression, Compression::kZstd);
  EXPECT_FALSE(outputs_of("outputs: {bag: false}").bag);
  EXPECT_TRUE(contains(output_refusal("outputs: {bag: {compression: gzip}}"), "gzip"));
  EXPECT_TRUE(contains(output_refusal("outputs: {bag: {particle: true}}"), "particles"));
}

TEST(OutputSpec, SnapshotsMayBeOneWord) {
  EXPECT_FALSE(outputs_of("outputs: {snapshots: false}").snapshots);
}

TEST(OutputSpec, SaysWhatDoesNotDo) {
  EXPECT_TRUE(
      contains(output_refusal("outputs: {snapshots: {width: 5}}"), "give from 16 to 4096 px"));
  EXPECT_TRUE(contains(output_refusal("outputs: {snapshots: {every_s: -1}}"), "give 0, or from"));
  EXPECT_TRUE(contains(output_refusal("outputs: {points: {every_s: 0}}"), "give from 0.01"));
  EXPECT_TRUE(contains(output_refusal("outputs: {video: {width: 641}}"), "even"));
  EXPECT_TRUE(contains(output_refusal("outputs: {video: {fps: 0}}"), "video.fps: 0"));
  EXPECT_TRUE(contains(output_refusal("outputs: {video: {speed: 0}}"), "video.speed: 0"));
  EXPECT_TRUE(contains(output_refusal("outputs: {video: {view: chaise}}"), "chase"));
  EXPECT_TRUE(contains(output_refusal("outputs: {reprot: true}"), "report"));
}

}  // namespace
}  // namespace castaway::testbed
