#include "client/cli/json.h"

#include <memory>

#include "absl/strings/str_cat.h"
#include "google/protobuf/io/coded_stream.h"
#include "google/protobuf/io/zero_copy_stream_impl_lite.h"
#include "google/protobuf/util/json_util.h"
#include "google/protobuf/util/type_resolver_util.h"

namespace celt::cli {
namespace {

constexpr char kUrlPrefix[] = "type.googleapis.com";

google::protobuf::util::TypeResolver& Types() {
  // Never destroyed: messages may be printed until the very end of the program.
  static auto& types = *google::protobuf::util::NewTypeResolverForDescriptorPool(
      kUrlPrefix, google::protobuf::DescriptorPool::generated_pool());
  return types;
}

/// Maps in the order of their keys.
std::string SerializeInOrder(const google::protobuf::Message& message) {
  std::string bytes;
  google::protobuf::io::StringOutputStream stream(&bytes);
  google::protobuf::io::CodedOutputStream coded(&stream);
  coded.SetSerializationDeterministic(true);
  message.SerializeToCodedStream(&coded);
  coded.Trim();
  return bytes;
}

const google::protobuf::FieldDescriptor* SetMember(const google::protobuf::Message& message) {
  const google::protobuf::OneofDescriptor* oneof = message.GetDescriptor()->oneof_decl(0);
  return message.GetReflection()->GetOneofFieldDescriptor(message, oneof);
}

}  // namespace

std::string ToJson(const google::protobuf::Message& message) {
  std::string json;
  const std::string url = absl::StrCat(kUrlPrefix, "/", message.GetDescriptor()->full_name());
  const auto status =
      google::protobuf::util::BinaryToJsonString(&Types(), url, SerializeInOrder(message), &json);
  GOOGLE_CHECK(status.ok()) << status.ToString();  // only for types that are not compiled in
  return json;
}

std::string ToJson(const std::string& name, const google::protobuf::Message& message) {
  return absl::StrCat("{\"", name, "\":", ToJson(message), "}");
}

std::string AnalysisField(const google::protobuf::Message& message) {
  const auto* member = SetMember(message);
  return member == nullptr ? "" : member->name();
}

std::string ResultJson(const v1::Result& result) {
  const auto* member = SetMember(result);
  if (member == nullptr) return "{\"result\":{}}";
  return ToJson("result", result.GetReflection()->GetMessage(result, member));
}

}  // namespace celt::cli
