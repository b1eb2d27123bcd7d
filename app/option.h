#pragma once

#include "renderer/result.h"
#include "renderer/settings/names.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace asos {

/// Adds an option whose text `parse` reads into `assign`, so that every refusal is a usage error
/// in our own words. `shape` is what the help shows in the value's place.
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

/// A parser of the names in a table such as method_names, which has to outlive it.
template <typename T, std::size_t N>
auto parse_name(const std::array<Named<T>, N>& known) {
  return [&known](const std::string& text) -> Result<T> {
    std::string names;
    for (const auto& [name, value] : known) {
      if (text == name) return value;
      names += (names.empty() ? "" : ", ") + std::string(name);
    }
    return tl::unexpected(Error{fmt::format("\"{}\"", text), "not one of " + names});
  };
}

/// An option that takes one of the names in a table; its default is what `value` is.
template <typename T, std::size_t N>
CLI::Option* add_choice(CLI::App& app, const char* option, const char* kind, const char* help,
                        const std::array<Named<T>, N>& known, T& value) {
  return add_parsed_option(app, option, kind, help, parse_name(known),
                           [&value](T chosen) { value = chosen; })
      ->default_str(name_in(known, value));
}

}  // namespace asos
