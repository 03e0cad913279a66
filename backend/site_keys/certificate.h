// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <openssl/pkcs7.h>
#include <openssl/x509.h>
#include <optional>
#include <string>

namespace teleta::site_keys {

struct FreeOpenSsl {
    void operator()(X509* one) const { X509_free(one); }
    void operator()(EVP_PKEY* one) const { EVP_PKEY_free(one); }
    void operator()(PKCS7* one) const { PKCS7_free(one); }
    void operator()(BIO* one) const { BIO_free_all(one); }
};
template <class T>
using Held = std::unique_ptr<T, FreeOpenSsl>;

/// The first certificate of a PEM file; null when there is none.
[[nodiscard]] Held<X509> readCertificate(const std::string& path);
/// The private key of a PEM file without a password; null when there is none.
[[nodiscard]] Held<EVP_PKEY> readKey(const std::string& path);

/// "CN=console1,O=TeleTA site": the order of RFC 2253.
[[nodiscard]] std::string subjectOf(const X509& certificate);
/// Seconds since 1970. Nothing for a time that cannot be read.
[[nodiscard]] std::optional<std::int64_t> beginOf(const X509& certificate);
[[nodiscard]] std::optional<std::int64_t> endOf(const X509& certificate);

/// Whether the authority signed it, whatever the dates.
[[nodiscard]] bool verifies(X509& certificate, X509& authority);

/// The text of an S/MIME file whose signer is the authority itself, not a certificate that it issued; nothing
/// otherwise.
[[nodiscard]] std::optional<std::string> signedText(const std::string& path, X509& authority);

} // namespace teleta::site_keys
