#include "replay/tape.hpp"

#include "replay/tape_format.hpp"

#include <cstring>
#include <stdexcept>

namespace ggrade::tape {

using nlohmann::json;

namespace {

constexpr std::size_t kMaxDepth = 12;
/// Values of all commands together.
constexpr std::size_t kMaxValues = 1'000'000;

/// Builds a value, and stops where it is nested too deep or too large.
class Limited : public nlohmann::detail::json_sax_dom_parser<json> {
public:
  using Base = nlohmann::detail::json_sax_dom_parser<json>;
  Limited(json& to, std::size_t& values) : Base(to, false), values_(values) {}

  bool start_object(std::size_t count) {
    return ++depth_ <= kMaxDepth && isFew() && isPossible(count) && Base::start_object(count);
  }
  bool end_object() {
    --depth_;
    return Base::end_object();
  }
  bool start_array(std::size_t count) {
    return ++depth_ <= kMaxDepth && isFew() && isPossible(count) && Base::start_array(count);
  }
  bool end_array() {
    --depth_;
    return Base::end_array();
  }
  bool null() { return isFew() && Base::null(); }
  bool boolean(bool value) { return isFew() && Base::boolean(value); }
  bool number_integer(json::number_integer_t value) {
    return isFew() && Base::number_integer(value);
  }
  bool number_unsigned(json::number_unsigned_t value) {
    return isFew() && Base::number_unsigned(value);
  }
  bool number_float(json::number_float_t value, const json::string_t& text) {
    return isFew() && Base::number_float(value, text);
  }
  bool string(json::string_t& value) { return isFew() && Base::string(value); }
  bool binary(json::binary_t&) { return false; }

private:
  bool isFew() { return ++values_ <= kMaxValues; }
  /// -1: a count that isn't said. The base class throws for what no memory holds.
  static bool isPossible(std::size_t count) {
    return count == static_cast<std::size_t>(-1) || count <= kMaxValues;
  }
  std::size_t depth_ = 0;
  std::size_t& values_;
};

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("tape: " + what);
}

json readCommand(std::span<const std::byte> bytes, std::size_t& values) {
  json command;
  Limited limited(command, values);
  const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
  if (!json::sax_parse(from, from + bytes.size(), &limited, json::input_format_t::cbor))
    fail("a command is no CBOR of a tape's shape");
  if (!command.is_object() || !command.contains("op") || !command["op"].is_string())
    fail("a command without op");
  return command;
}

void append(std::vector<std::byte>& to, EntryKind kind, std::span<const std::byte> bytes) {
  const EntryHead head{static_cast<std::uint32_t>(kind), 0, bytes.size()};
  const auto* raw = reinterpret_cast<const std::byte*>(&head);
  to.insert(to.end(), raw, raw + sizeof head);
  to.insert(to.end(), bytes.begin(), bytes.end());
  to.resize(to.size() + (padded(bytes.size()) - bytes.size()));
}

} // namespace

Tape read(std::span<const std::byte> bytes) {
  Tape tape;
  std::size_t values = 0;
  while (!bytes.empty()) {
    EntryHead head{};
    if (bytes.size() < sizeof head) fail("ends within an entry's head");
    std::memcpy(&head, bytes.data(), sizeof head);
    bytes = bytes.subspan(sizeof head);
    if (head.bytes > bytes.size() || padded(head.bytes) > bytes.size())
      fail("an entry is larger than what is left");
    const auto body = bytes.first(head.bytes);
    bytes = bytes.subspan(padded(head.bytes));
    switch (static_cast<EntryKind>(head.kind)) {
    case EntryKind::blob:
      if (tape.blobs.size() >= kMaxBlobs) fail("more than 20000 blobs");
      tape.blobs.emplace_back(body.begin(), body.end());
      break;
    case EntryKind::command:
      if (tape.commands.size() >= kMaxCommands) fail("more than 20000 commands");
      tape.commands.push_back(readCommand(body, values));
      break;
    default:
      fail("an entry of an unknown kind");
    }
  }
  return tape;
}

std::vector<std::byte> write(const Tape& tape) {
  std::vector<std::byte> bytes;
  for (const auto& blob : tape.blobs) append(bytes, EntryKind::blob, blob);
  for (const json& command : tape.commands) {
    const std::vector<std::uint8_t> cbor = json::to_cbor(command);
    append(bytes, EntryKind::command, std::as_bytes(std::span(cbor)));
  }
  return bytes;
}

} // namespace ggrade::tape
