#include "sim/world/sdf/model_spread.hpp"

#include <string>

#include <gtest/gtest.h>

#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

std::string model(const std::string& pose, const std::string& inside) {
  return "<model name='m'>" + pose + "<link name='l'>" + inside + "</link></model>";
}

std::string solid(const std::string& pose = "") {
  return "<collision name='c'>" + pose +
         "<geometry><box><size>1 1 1</size></box></geometry></collision>";
}

Eigen::Vector2d spread_of(const std::string& models) {
  const auto document = parse_xml("w.sdf", "<world>" + models + "</world>");
  ModelSpread spread;
  for (const TiXmlElement* element = document->RootElement()->FirstChildElement();
       element != nullptr; element = element->NextSiblingElement()) {
    spread.add(*element);
  }
  return spread.size();
}

TEST(ModelSpread, IsThatOfPoses) {
  EXPECT_EQ(spread_of(model("<pose>-700 2 0 0 0 0</pose>", solid()) + model("", solid()) +
                      model("<pose>800 5 1 0 0 0</pose>", solid())),
            Eigen::Vector2d(1500.0, 5.0));
}

TEST(ModelSpread, IsLessByWhatBodiesMayBeAwayFromTheirModels) {
  EXPECT_EQ(spread_of(model("<pose>-700 0 0 0 0 0</pose>", solid("<pose>0 300 400 0 0 0</pose>")) +
                      model("<pose>800 0 0 0 0 0</pose>", solid())),
            Eigen::Vector2d(1000.0, 0.0));
}

TEST(ModelSpread, LeavesOutModelsOfWhichItKnowsTooLittle) {
  const std::string far = "<pose>9999 0 0 0 0 0</pose>";
  EXPECT_EQ(spread_of(""), Eigen::Vector2d::Zero());
  EXPECT_EQ(spread_of(model("", solid()) + model(far, "") +
                      model("<pose relative_to='f'>9999 0 0 0 0 0</pose>", solid()) +
                      model(far, solid() + "<include/>") +
                      model(far, "<collision name='c'><geometry><mesh/></geometry></collision>")),
            Eigen::Vector2d::Zero());
}

}  // namespace
}  // namespace castaway::sim
