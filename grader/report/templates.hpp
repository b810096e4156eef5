#pragma once
/// \file
/// The files of templates/, embedded at build time by embed.cmake.

#include <string_view>

namespace ggrade::report::templates {

extern const std::string_view k_head_mustache;
extern const std::string_view k_result_mustache;
extern const std::string_view k_overview_mustache;
extern const std::string_view k_style_css;
extern const std::string_view k_page_js;
extern const std::string_view k_page_js_sha256; ///< 64 hexadecimal digits
extern const std::string_view k_inspect_mustache;
extern const std::string_view k_inspect_css;
extern const std::string_view k_inspect_js;
extern const std::string_view k_inspect_js_sha256;
extern const std::string_view k_calibration_mustache;
extern const std::string_view k_calibration_css;
extern const std::string_view k_tradeoff_mustache;
extern const std::string_view k_tradeoff_css;
extern const std::string_view k_check_mustache;
extern const std::string_view k_check_css;
extern const std::string_view k_check_js;
extern const std::string_view k_check_js_sha256;
extern const std::string_view k_class_mustache;
extern const std::string_view k_class_css;
extern const std::string_view k_class_js;
extern const std::string_view k_class_js_sha256;

} // namespace ggrade::report::templates
