// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site_keys/certificate.h"

#include <ctime>
#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509_vfy.h>

namespace teleta::site_keys {

namespace {

Held<BIO> fileAt(const std::string& path) {
    return Held<BIO>(BIO_new_file(path.c_str(), "rb"));
}

std::string contentOf(BIO* memory) {
    char* data = nullptr;
    const long size = BIO_get_mem_data(memory, &data);
    return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string();
}

std::optional<std::int64_t> secondsOf(const ASN1_TIME* time) {
    std::tm parts{};
    if (time == nullptr || ASN1_TIME_to_tm(time, &parts) != 1)
        return std::nullopt;
    return timegm(&parts);
}

struct FreeStore {
    void operator()(X509_STORE* store) const { X509_STORE_free(store); }
    void operator()(X509_STORE_CTX* context) const { X509_STORE_CTX_free(context); }
};

using Store = std::unique_ptr<X509_STORE, FreeStore>;

Store storeOf(X509& authority) {
    Store store(X509_STORE_new());
    X509_STORE_add_cert(store.get(), &authority);
    // Dates are told apart from signatures.
    X509_STORE_set_flags(store.get(), X509_V_FLAG_NO_CHECK_TIME);
    return store;
}

} // namespace

Held<X509> readCertificate(const std::string& path) {
    const Held<BIO> file = fileAt(path);
    return Held<X509>(file ? PEM_read_bio_X509(file.get(), nullptr, nullptr, nullptr) : nullptr);
}

Held<EVP_PKEY> readKey(const std::string& path) {
    const Held<BIO> file = fileAt(path);
    // A key with a password must not ask for it on the terminal.
    const auto noPassword = [](char*, int, int, void*) { return -1; };
    return Held<EVP_PKEY>(file ? PEM_read_bio_PrivateKey(file.get(), nullptr, noPassword, nullptr) : nullptr);
}

std::string subjectOf(const X509& certificate) {
    const Held<BIO> text(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(text.get(), X509_get_subject_name(&certificate), 0,
                       XN_FLAG_RFC2253 & ~ASN1_STRFLGS_ESC_MSB);
    return contentOf(text.get());
}

std::optional<std::int64_t> beginOf(const X509& certificate) {
    return secondsOf(X509_get0_notBefore(&certificate));
}

std::optional<std::int64_t> endOf(const X509& certificate) {
    return secondsOf(X509_get0_notAfter(&certificate));
}

bool verifies(X509& certificate, X509& authority) {
    const Store store = storeOf(authority);
    const std::unique_ptr<X509_STORE_CTX, FreeStore> context(X509_STORE_CTX_new());
    const bool valid = X509_STORE_CTX_init(context.get(), store.get(), &certificate, nullptr) == 1 &&
                       X509_verify_cert(context.get()) == 1;
    ERR_clear_error();
    return valid;
}

std::optional<std::string> signedText(const std::string& path, X509& authority) {
    const Held<BIO> file = fileAt(path);
    if (!file)
        return std::nullopt;
    BIO* detached = nullptr;
    const Held<PKCS7> signature(SMIME_read_PKCS7(file.get(), &detached));
    const Held<BIO> content(detached);
    const Held<BIO> text(BIO_new(BIO_s_mem()));
    STACK_OF(X509)* signers = sk_X509_new_null();
    sk_X509_push(signers, &authority);
    const Store store = storeOf(authority);
    // PKCS7_NOINTERN: only the authority's own key counts, not one of a certificate that lies in the file.
    const bool valid = signature && PKCS7_verify(signature.get(), signers, store.get(), content.get(),
                                                 text.get(), PKCS7_TEXT | PKCS7_NOINTERN) == 1;
    sk_X509_free(signers);
    ERR_clear_error();
    if (!valid)
        return std::nullopt;
    return contentOf(text.get());
}

} // namespace teleta::site_keys
