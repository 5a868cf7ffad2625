#include "tools/base/output/any_error.hpp"

#include <cxxabi.h>

#include <cstdlib>
#include <exception>
#include <memory>
#include <typeinfo>

#include "tools/base/output/interruption.hpp"

namespace castaway::testbed {
namespace {

std::string current_type() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  if (type == nullptr) return "an unknown type";
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(type->name(), nullptr, nullptr, &status), std::free);
  return name ? name.get() : type->name();
}

}  // namespace

std::string current_error_text() {
  try {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "a library failed with an exception of type " + current_type();
  }
}

}  // namespace castaway::testbed
