#include "reports/html/html_document.h"

#include "reports/html/assets.h"
#include "reports/html/html_text.h"

namespace cuesta::html {

std::string html_document(const std::string& title, const std::string& headline, const std::string& facts,
                          const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
         "<meta name=\"color-scheme\" content=\"light dark\">"
         "<link rel=\"icon\" href=\"data:,\"><title>" +
         escape(title) + "</title>\n<style>" + std::string(kStyleSheet) +
         "</style></head>\n<body><main>\n<header><p class=\"headline\">" +
         with_firm_spaces(escape(headline)) + "</p><h1>" + escape(title) + "</h1><p class=\"facts\">" +
         escape(facts) + "</p></header>\n" + body +
         "</main><div id=\"tip\" role=\"status\" hidden></div>\n<script>" + std::string(kScript) +
         "</script></body></html>\n";
}

}  // namespace cuesta::html
