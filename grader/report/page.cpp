#include "report/page.hpp"

#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <stdexcept>
#include <vector>

namespace ggrade::report {
namespace {

Data orFalse(std::string clean) {
  return clean.empty() ? Data(false) : Data(clean);
}

// The Content-Security-Policy admits this one script by its hash: markup that slipped through as
// text could not run.
std::string scriptHash(std::string_view sha256) {
  std::vector<unsigned char> bytes;
  const std::string hex(sha256);
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<unsigned char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return "sha256-" + base64(bytes);
}

} // namespace

Data line(std::string_view text) {
  return orFalse(sanitizeLine(text));
}

Data text(std::string_view text) {
  return orFalse(sanitize(text));
}

void addLanguage(Data& page) {
  page["lang"] = Data(std::string(gg::name(gg::language())));
  page["say"] = Data(kainjow::mustache::lambda(
      [](const std::string& english) { return std::string(gg::words(english)); }));
}

std::string renderPage(const PageKind& kind, Data data, std::string_view title) {
  data["head"] = Data(std::string(templates::k_head_mustache));
  data["style"] = Data(std::string(templates::k_style_css) + std::string(kind.style));
  data["script"] = Data(std::string(kind.script));
  data["scriptHash"] = Data(scriptHash(kind.scriptSha256));
  data["pageTitle"] = line(title);
  kainjow::mustache::mustache page{std::string(kind.body)};
  std::string html = page.render(data);
  if (!page.is_valid()) throw std::logic_error("page template: " + page.error_message());
  return html;
}

std::string renderPage(std::string_view body, Data data, std::string_view title) {
  return renderPage({body, templates::k_page_js, templates::k_page_js_sha256, ""}, std::move(data),
                    title);
}

} // namespace ggrade::report
