#include "tools/base/bytes/sha256.hpp"

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

class Digest {
 public:
  Digest() {
    OPENSSL_init_crypto(OPENSSL_INIT_NO_LOAD_CONFIG, nullptr);  // The machine's openssl.cnf.
    context_.reset(EVP_MD_CTX_new());
    check(context_ != nullptr && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }

  void add(std::string_view bytes) {
    check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1);
  }

  [[nodiscard]] std::string text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
    unsigned int size = 0;
    check(EVP_DigestFinal_ex(context_.get(), sum.data(), &size) == 1);
    std::string digits;
    for (unsigned int i = 0; i < size; ++i) digits += fmt::format("{:02x}", sum[i]);
    return digits;
  }

 private:
  static void check(bool good) {
    if (!good) throw std::runtime_error("SHA-256 is not to be had from the OpenSSL library");
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{nullptr, EVP_MD_CTX_free};
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.text();
}

std::string sha256_of_file(const std::filesystem::path& file) {
  require_regular_file(file);
  std::ifstream stream(file, std::ios::binary);
  Digest digest;
  std::array<char, 1 << 16> buffer{};
  while (stream) {
    stream.read(buffer.data(), buffer.size());
    digest.add({buffer.data(), static_cast<std::size_t>(stream.gcount())});
  }
  if (!stream.eof()) {
    throw std::runtime_error(
        fmt::format("{}: cannot be read; check the path and its permissions", file.string()));
  }
  return digest.text();
}

}  // namespace castaway::testbed
