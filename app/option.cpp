#include "app/option.h"

namespace asos {

CLI::Option* add_setting(CLI::App& app, const char* option, const char* shape,
                         RenderSettings& settings, const std::string& more) {
  const SettingRow& row = setting_of_option(option);
  return add_parsed_option(
             app, "--" + std::string(option), shape, row.about + more,
             [&row](const std::string& text) { return row.parse(text); },
             [&row, &settings](double value) { row.set(settings, value); })
      ->default_str(row.text_of(row.get(settings)));
}

}  // namespace asos
