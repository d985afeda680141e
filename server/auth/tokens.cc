#include "server/auth/tokens.h"

#include <openssl/rand.h>
#include <openssl/sha.h>

#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"

namespace celt::auth {
namespace {

constexpr std::size_t kHashLength = 2 * SHA256_DIGEST_LENGTH;

template <std::size_t size>
std::string Hexadecimal(const std::array<unsigned char, size>& bytes) {
  std::string text;
  for (const unsigned char byte : bytes) absl::StrAppend(&text, absl::Hex(byte, absl::kZeroPad2));
  return text;
}

absl::Status CheckEntry(const std::string& role, const std::string& hash, const std::string& rest) {
  if (role != "user" && role != "admin") {
    return absl::InvalidArgumentError("the role is neither user nor admin");
  }
  if (hash.size() != kHashLength ||
      hash.find_first_not_of("0123456789abcdef") != std::string::npos) {
    return absl::InvalidArgumentError("the hash is not 64 hexadecimal digits");
  }
  if (!rest.empty()) return absl::InvalidArgumentError("there is more than OWNER ROLE HASH");
  return absl::OkStatus();
}

}  // namespace

std::string NewToken() {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> bytes;
  if (RAND_bytes(bytes.data(), bytes.size()) != 1) throw std::runtime_error("no random bytes");
  return Hexadecimal(bytes);
}

std::string HashOf(std::string_view token) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
  const std::string bytes(token);
  std::array<unsigned char, 1> none{};
  const auto* data =
      bytes.empty() ? none.data() : reinterpret_cast<const unsigned char*>(bytes.data());
  SHA256(data, bytes.size(), digest.data());
  return Hexadecimal(digest);
}

std::string TokenLine(const Identity& identity, std::string_view token) {
  return absl::StrCat(identity.owner, identity.admin ? " admin " : " user ", HashOf(token));
}

absl::StatusOr<std::unique_ptr<TokenFile>> TokenFile::Open(const std::string& path,
                                                           WatchOptions options) {
  std::unique_ptr<TokenFile> file(new TokenFile(path, std::move(options)));
  CELT_ASSIGN_OR_RETURN(file->identities_, file->Read());
  return file;
}

std::optional<Identity> TokenFile::Find(std::string_view token) {
  // A look-up by the hash: how long it takes tells nothing of the tokens.
  const std::string hash = HashOf(token);
  const std::lock_guard lock(mutex_);
  LookAgain();
  const auto found = identities_.find(hash);
  if (found == identities_.end()) return std::nullopt;
  return found->second;
}

void TokenFile::LookAgain() {
  if (!file_.Changed()) return;
  absl::StatusOr<Identities> identities = Read();
  if (!identities.ok()) return on_error_(identities.status());
  identities_ = *std::move(identities);
}

absl::StatusOr<TokenFile::Identities> TokenFile::Read() const {
  std::ifstream file(path_);
  if (!file) return absl::NotFoundError(absl::StrCat(path_, ": can't be read"));
  Identities identities;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::istringstream words(line);
    std::string owner;
    std::string role;
    std::string hash;
    std::string rest;
    if (!(words >> owner) || owner.starts_with('#')) continue;
    words >> role >> hash >> rest;
    if (const absl::Status status = CheckEntry(role, hash, rest); !status.ok()) {
      return absl::InvalidArgumentError(absl::StrCat(path_, ":", number, ": ", status.message()));
    }
    identities[hash] = {owner, role == "admin"};
  }
  return identities;
}

}  // namespace celt::auth
