#pragma once

#include "renderer/result.h"
#include "renderer/settings/names.h"
#include "renderer/settings/setting_table.h"
#include "renderer/settings/value_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace asos {

/// Adds an option whose text `parse` converts and `assign` stores; its errors become usage errors.
/// `shape` is the placeholder for the value in the help.
template <typename Parse, typename Assign>
CLI::Option* add_parsed_option(CLI::App& app, const std::string& name, const std::string& shape,
                               const std::string& help, Parse parse, Assign assign) {
  return app
      .add_option_function<std::string>(
          name,
          [name, parse, assign](const std::string& text) {
            auto value = parse(text);
            if (!value) throw CLI::ValidationError(name, value.error().message());
            assign(*std::move(value));
          },
          help)
      ->type_name(shape);
}

/// Returns a parser of the names in a table such as leaf_names, which must outlive it.
template <typename Named, std::size_t N>
auto name_parser(std::span<const Named, N> known) {
  return [known](const std::string& text) { return parse_name(text, known); };
}

/// Adds an option with one of the names in a table as its value; the default is the current
/// `value`.
template <typename Names, typename T>
CLI::Option* add_choice(CLI::App& app, const char* option, const char* kind, const char* help,
                        const Names& known, T& value) {
  return add_parsed_option(app, option, kind, help, name_parser(std::span(known)),
                           [&value](T chosen) { value = chosen; })
      ->default_str(name_in(known, value));
}

/// Adds the option of a setting, with its help, range and default; `more` follows the help.
CLI::Option* add_setting(CLI::App& app, const char* option, const char* shape,
                         RenderSettings& settings, const std::string& more = {});

}  // namespace asos
